#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "common/bus/sequence_monitor.hpp"

namespace markservo::bus {

// The latencies of a channel's last few hundred messages and last half minute, for percentiles that follow the present.
class LatencyWindow {
 public:
  using Time = std::chrono::steady_clock::time_point;

  void add(double seconds, Time now);
  // The value below which `share` (0..1) of the window lies, s; 0 when empty.
  double percentile(double share, Time now) const;

 private:
  struct Latency {
    double seconds = 0.0;
    Time when;
  };

  std::array<Latency, 512> values_{};
  std::size_t count_ = 0;
  std::size_t next_ = 0;
};

// What one subscription has seen since the start; ChannelStatus.lcm defines each figure.
struct ChannelCounters {
  std::int64_t received = 0;
  std::int64_t skipped = 0;
  std::int64_t decode_failures = 0;
  std::int64_t refused = 0;
  std::int64_t newest_utime = -1;  // us, of those on the bus's time line; -1 before the first
  SequenceMonitor sequence;
  LatencyWindow latency;
};

}  // namespace markservo::bus
