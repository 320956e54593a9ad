#pragma once

#include <cstdint>
#include <deque>

namespace markservo::bus {

// Follows (session, seq) of one channel: counts what was lost and notices a second writer.
// `session` is 1 or more and `seq` 0 to 2^53, as the message rules demand. A writer that restarts changes the session
// once; when an earlier session speaks again, two write at the same time.
class SequenceMonitor {
 public:
  void observe(int64_t session, int64_t seq);

  int64_t lost() const { return lost_; }
  bool second_writer() const { return second_writer_; }
  // True if the newest message began another session than the one before it.
  bool session_changed() const { return session_changed_; }

 private:
  static constexpr std::size_t kRemembered = 16;  // earlier sessions; more restarts than that in a row prove nothing

  static constexpr int64_t kMaxLost = int64_t{1} << 62;  // a hostile writer's gaps add up to no more

  int64_t session_ = 0;
  int64_t seq_ = 0;
  int64_t lost_ = 0;
  bool second_writer_ = false;
  bool session_changed_ = false;
  std::deque<int64_t> earlier_;
};

}  // namespace markservo::bus
