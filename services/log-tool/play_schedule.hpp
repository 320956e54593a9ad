#pragma once

// When the messages of a log are due, at a multiple of the recorded pace. No clock: "now" is given.

#include <cmath>
#include <cstdint>
#include <limits>

#include "services/log-tool/time_walk.hpp"

namespace markservo::log_tool {

class PlaySchedule {
 public:
  // `speed`: times the recorded pace, above 0. `longest_gap`: as TimeWalk has it.
  explicit PlaySchedule(double speed, double longest_gap = std::numeric_limits<double>::infinity())
      : speed_(speed), walk_(longest_gap) {}

  // When the message recorded at `utime` is due, us of the clock of `now_us`, which is read just before. Each is due as
  // long after the one that began the time line as it was recorded, so that delays do not add up. Where the log's time
  // jumps (time_walk.hpp), a new time line begins at once.
  std::int64_t due_us(std::int64_t utime, std::int64_t now_us) {
    const TimeWalk::Step step = walk_.to(utime);
    if (!begun_ || step.jumped) {
      begun_ = true;
      first_us_ = now_us;
      first_due_s_ = step.due_s;
    }
    return first_us_ + std::llround(1e6 * (step.due_s - first_due_s_) / speed_);
  }

 private:
  double speed_;
  TimeWalk walk_;
  bool begun_ = false;
  std::int64_t first_us_ = 0;  // when the time line began
  double first_due_s_ = 0.0;   // of the walk, then
};

}  // namespace markservo::log_tool
