#pragma once

#include <array>
#include <cstdint>

#include "common/bus/sequence_monitor.hpp"

namespace markservo::bus {

// The last few hundred latencies of a channel, for percentiles that follow the present.
class LatencyWindow {
 public:
  void add(double seconds);
  // The value below which `share` (0..1) of the window lies, s; 0 when empty.
  double percentile(double share) const;

 private:
  std::array<double, 512> values_{};
  std::size_t count_ = 0;
  std::size_t next_ = 0;
};

// What one subscription has seen since the start; ChannelStatus.lcm defines each figure.
struct ChannelCounters {
  int64_t received = 0;
  int64_t skipped = 0;
  int64_t decode_failures = 0;
  int64_t refused = 0;
  int64_t newest_utime = -1;  // us; -1 before the first
  SequenceMonitor sequence;
  LatencyWindow latency;
};

}  // namespace markservo::bus
