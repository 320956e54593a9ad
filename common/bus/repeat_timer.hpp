#pragma once

#include <cstdint>

namespace markservo::bus {

// LCM keeps nothing for latecomers: goals and states are repeated, by the time of the messages.
class RepeatTimer {
 public:
  explicit RepeatTimer(std::int64_t period_us) : period_us_(period_us) {}

  // True when `utime` (us) is a period past the last time it was; also at first and when time went back.
  bool due(std::int64_t utime) {
    if (started_ && utime >= last_ && utime - last_ < period_us_) return false;
    started_ = true;
    last_ = utime;
    return true;
  }

  // Begins a new period, after something was sent for another reason.
  void restart(std::int64_t utime) {
    started_ = true;
    last_ = utime;
  }

 private:
  std::int64_t period_us_;
  bool started_ = false;
  std::int64_t last_ = 0;
};

inline constexpr std::int64_t kStateRepeat_us =
    200'000;  // goals and states: a restarted service knows them within 0.2 s

}  // namespace markservo::bus
