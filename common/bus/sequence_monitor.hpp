#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>

namespace markservo::bus {

// A hostile writer's gaps add up to no more.
inline constexpr int64_t kMaxLost = int64_t{1} << 53;

// Messages missing between two `seq` of one session, the earlier heard first; none where the later one comes late or
// twice. Any numbers: one below 0 is no seq, and a hostile writer's gap counts as no more than kMaxLost.
inline int64_t sequence_gap(int64_t before, int64_t after) {
  return before < 0 || after <= before ? 0 : std::min(after - before - 1, kMaxLost);
}

// Follows (session, seq) of one channel: counts what was lost and notices a second writer.
// `session` is 1 or more and `seq` 0 to 2^53, as the message rules demand. A writer that restarts changes the session
// once; when an earlier session speaks again, two write at the same time.
class SequenceMonitor {
 public:
  //
  // A number far from all others, which a hostile or broken writer sends, counts for nothing unless the next goes on
  // from it: then there was a gap that long.
  void observe(int64_t session, int64_t seq);

  int64_t lost() const { return lost_; }
  // Until one alone has sent kForgotten messages.
  bool second_writer() const { return second_writer_; }
  // True if the newest message began another session than the one before it.
  bool session_changed() const { return session_changed_; }

 private:
  static constexpr std::size_t kRemembered = 16;  // earlier sessions; more restarts than that in a row prove nothing
  static constexpr int kForgotten = 500;          // messages of one session in a row: 5 s of the quickest stream
  static constexpr int64_t kFar = 100;            // messages; a longer gap is believed one message later

  void follow(int64_t seq);

  int64_t session_ = 0;
  int64_t seq_ = 0;
  std::optional<int64_t> far_;  // a number far from seq_ that nothing has confirmed yet
  int64_t lost_ = 0;
  bool second_writer_ = false;
  int in_a_row_ = 0;  // of the present session
  bool session_changed_ = false;
  std::deque<int64_t> earlier_;
};

}  // namespace markservo::bus
