#pragma once

// A channel that one may write. Who writes keeps the floor while it speaks; another one is heard when the floor has
// been free for a while, as after a restart. When the first speaks again after another did, or takes the floor back,
// two write, until one writes alone again: then it is heard, and whether anything may move by it is for its reader's
// ConflictGuard to say.

#include <cstdint>
#include <optional>
#include <string>

#include "common/motion/arrival_order.hpp"
#include "common/motion/stamp.hpp"

namespace markservo::motion {

// "two write TARGET_POSE: sessions 12 and 34".
std::string two_write(const std::string& what, std::int64_t one, std::int64_t other);

struct WriterParameters {
  double floor = 0.3;  // s of silence after which another may take the floor: what moves stands by then
  double alone = 1.0;  // s without another's word after which one writes alone again
  double gone = 5.0;   // s in which one that lost the floor and takes it back shows that it had not ended
  ArrivalParameters arrival;
};

// What becomes of a message of the channel.
enum class StreamHeard {
  kTaken,   // in its turn
  kAnew,    // of a writer that took the floor, has it alone again, or began anew: what is known of before does not hold
  kLate,    // comes late, twice or out of turn: to be dropped
  kWaits,   // of another than who has the floor: to be dropped
  kSecond,  // of who has the floor, after another spoke: two write
};

class SoleWriter {
 public:
  explicit SoleWriter(std::string channel, WriterParameters parameters = {})
      : channel_(std::move(channel)), parameters_(parameters) {}

  // `now`: us, the newest time of what is moved; 0 while that has none.
  StreamHeard hear(const Stamp& stamp, std::int64_t now);

  // No other has spoken for so long that one writes alone.
  bool alone(std::int64_t now) const;
  // Who has the floor; 0 before the first message.
  std::int64_t session() const { return session_; }
  // The one that spoke last beside it; 0 when none did since it took the floor.
  std::int64_t other() const { return other_ ? other_->session : 0; }
  // Which two write.
  std::string words() const { return two_write(channel_, session_, other()); }
  // What was said beside the writer is settled; nothing of it is held against anyone.
  void settle() {
    other_.reset();
    former_.reset();
  }
  // To be called when all times are of another clock from now on.
  void forget_order() { order_.forget(); }

 private:
  struct Other {
    std::int64_t session = 0;
    std::int64_t first_utime = 0;
    std::int64_t heard_at = 0;  // us, of now
    bool told = false;          // that two write
  };

  StreamHeard hear_another(const Stamp& stamp, std::int64_t now);

  std::string channel_;
  WriterParameters parameters_;
  ArrivalOrder order_;
  std::int64_t session_ = 0;
  std::int64_t heard_at_ = 0;  // us, of now
  std::optional<Other> other_;
  std::optional<Other> former_;  // who had the floor before
};

}  // namespace markservo::motion
