#pragma once

// What one channel does, seen from outside: no clock, times come in.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "common/bus/gap_counter.hpp"
#include "common/reflection/message_note.hpp"

namespace markservo::watch {

struct ChannelWatchParameters {
  double window = 5.0;            // s: rates and writers are of this last time; a 1 Hz channel has five messages in it
  double silence = 1.0;           // s: nothing is stale before that
  double missed_intervals = 3.0;  // a channel is stale once so many of its usual intervals have passed
};

struct ChannelFigures {
  std::string type;  // of the newest message; empty: not known
  std::optional<std::uint64_t> fingerprint;
  std::int64_t received = 0;
  std::int64_t bytes = 0;                  // of all messages
  std::size_t newest_bytes = 0;            // of the newest message
  std::optional<double> hz;                // none: fewer than two messages in the window
  std::optional<double> bytes_per_second;  // likewise
  double age = 0.0;                        // s since the newest message
  bool stale = false;
  std::optional<std::int64_t> lost;  // gaps in seq, each writer's own; none: the type has no seq
  std::int64_t undecodable = 0;
  std::int64_t writers = 0;   // sessions heard in the window
  std::int64_t sessions = 0;  // heard at all
};

// Watches one channel. `now` is seconds of any clock that does not go back. Keeps a bounded number of messages' times
// and of writers, whatever comes.
class ChannelWatch {
 public:
  explicit ChannelWatch(ChannelWatchParameters parameters = {}) : parameters_(parameters) {}

  void observe(const reflection::MessageNote& note, double now);
  // After the first observe().
  ChannelFigures figures(double now) const;

 private:
  struct Arrival {
    double time;
    std::size_t bytes;
  };
  struct Writer {
    double heard = 0.0;
    bus::GapCounter gaps;
  };

  void follow(std::int64_t session, std::int64_t seq, double now);

  ChannelWatchParameters parameters_;
  reflection::MessageNote newest_;
  std::deque<Arrival> arrivals_;  // of the window before the newest
  std::map<std::int64_t, Writer> writers_;
  double interval_ = 0.0;  // s, the usual one; 0: not known yet
  std::int64_t received_ = 0;
  std::int64_t bytes_ = 0;
  std::optional<std::int64_t> lost_;
  std::int64_t undecodable_ = 0;
  std::int64_t sessions_ = 0;
};

}  // namespace markservo::watch
