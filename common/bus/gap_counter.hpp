#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace markservo::bus {

// A hostile writer's gaps add up to no more, and no seq is larger.
inline constexpr std::int64_t kMaxLost = std::int64_t{1} << 53;

// Counts the messages that one writer's `seq` leave out. A number ahead of the next is believed once another goes on
// from it: one alone, which a hostile or broken writer sends, counts for nothing and hides nothing. One that comes late
// or twice loses nothing. So a gap is counted with the second message behind it: one before a writer's last message is
// not.
class GapCounter {
 public:
  // `seq`: any number; one outside of 0 to kMaxLost is no seq. How many it shows to be missing; 0 to kMaxGap.
  std::int64_t observe(std::int64_t seq) {
    if (seq < 0 || seq > kMaxLost) return 0;
    if (newest_ < 0 || seq == newest_ + 1) {
      newest_ = seq;
      // What stood ahead came before its turn only.
      if (ahead_ && *ahead_ == newest_ + 1) newest_ = *ahead_;
      if (ahead_ && *ahead_ <= newest_) ahead_.reset();
      return 0;
    }
    if (seq <= newest_ && newest_ - seq <= kFar) return 0;
    if (!ahead_ || seq <= *ahead_ || seq - *ahead_ > kFar) {
      ahead_ = seq;
      return 0;
    }
    const std::int64_t missing = std::clamp<std::int64_t>(*ahead_ - newest_ - 1, 0, kMaxGap);
    newest_ = *ahead_;
    ahead_ = seq;
    if (seq == newest_ + 1) observe(seq);
    return missing;
  }

 private:
  static constexpr std::int64_t kFar = 100;  // messages; what is farther from another does not go on from it
  // Two that lie agree as well as two that do not. So much is 100 s of the quickest stream; whoever is deaf for longer
  // is told by the age of what he has.
  static constexpr std::int64_t kMaxGap = 10'000;

  std::int64_t newest_ = -1;
  std::optional<std::int64_t> ahead_;  // not where the next was expected, and nothing has gone on from it yet
};

}  // namespace markservo::bus
