#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/bus/gap_counter.hpp"

namespace markservo::bus {

// Follows (session, seq) of one channel: counts what was lost and notices a second writer.
// `session` is 1 or more and `seq` 0 to 2^53, as the message rules demand. A writer that restarts changes the session
// once; when an earlier session speaks again, two write at the same time.
class SequenceMonitor {
 public:
  void observe(std::int64_t session, std::int64_t seq);

  // Gaps within each session, as GapCounter finds them.
  std::int64_t lost() const { return lost_; }
  // Until one alone has sent kForgotten messages.
  bool second_writer() const { return second_writer_; }
  // True if the newest message began another session than the one before it.
  bool session_changed() const { return session_changed_; }

 private:
  static constexpr std::size_t kRemembered = 16;  // earlier sessions; more restarts than that in a row prove nothing
  static constexpr int kForgotten = 500;          // messages of one session in a row: 5 s of the quickest stream

  std::int64_t session_ = 0;
  GapCounter gaps_;  // of the present session
  std::int64_t lost_ = 0;
  bool second_writer_ = false;
  int in_a_row_ = 0;  // of the present session
  bool session_changed_ = false;
  std::vector<std::int64_t> earlier_;
};

}  // namespace markservo::bus
