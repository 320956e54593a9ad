#pragma once

#include <cstdint>
#include <optional>

namespace markservo::rfid_localizer {

// The times of one input's messages, which grow from one to the next. Where they do not, the message is late, unless
// another driver speaks or so many come late in a row that the clock was set back: then all begins anew.
class InputTimes {
 public:
  enum class Step { kOn, kLate, kAnew };

  // What a message of `utime` (us) and its driver's `session` is after the last one. Each late one counts.
  Step judge(std::int64_t utime, std::int64_t session) {
    if (!last_ || utime > *last_) return Step::kOn;
    return session == session_ && ++late_in_a_row_ <= kMostLate ? Step::kLate : Step::kAnew;
  }
  // That message is the last one now.
  void accept(std::int64_t utime, std::int64_t session) {
    last_ = utime;
    session_ = session;
    late_in_a_row_ = 0;
  }
  // The next one is the first one.
  void forget() { last_.reset(); }

  // us
  const std::optional<std::int64_t>& last() const { return last_; }

 private:
  static constexpr int kMostLate = 20;

  std::optional<std::int64_t> last_;
  std::int64_t session_ = 0;
  int late_in_a_row_ = 0;
};

}  // namespace markservo::rfid_localizer
