#pragma once

// When the messages of a log are due, at a multiple of the recorded pace. No clock: "now" is given.

#include <cmath>
#include <cstdint>

#include "services/log-tool/log_event.hpp"

namespace markservo::log_tool {

class PlaySchedule {
 public:
  // `speed`: times the recorded pace, above 0.
  explicit PlaySchedule(double speed) : speed_(speed) {}

  // When the message recorded at `utime` is due, us of the clock of `now_us`, which is read just before. Each is due as
  // long after the one that began the time line as it was recorded, so that delays do not add up. Where the log's time
  // goes back by more than a second, or on by more than a day (a clock that was set), a new time line begins at once.
  std::int64_t due_us(std::int64_t utime, std::int64_t now_us) {
    const double step_s = seconds_apart(last_utime_, utime);
    const bool jump = begun_ && (step_s < -kLargestStepBack_s || step_s > kLargestGap_s);
    if (jump) ++jumps_;
    if (jump || !begun_) {
      begun_ = true;
      first_utime_ = utime;
      first_us_ = now_us;
    }
    last_utime_ = utime;
    return first_us_ + std::llround(1e6 * seconds_apart(first_utime_, utime) / speed_);
  }

  // How often a new time line began.
  int jumps() const { return jumps_; }

 private:
  static constexpr double kLargestStepBack_s = 1.0;  // less is disorder: such a message is due at once
  static constexpr double kLargestGap_s = 86400.0;

  double speed_;
  bool begun_ = false;
  std::int64_t first_utime_ = 0;
  std::int64_t last_utime_ = 0;
  std::int64_t first_us_ = 0;
  int jumps_ = 0;
};

}  // namespace markservo::log_tool
