#pragma once

// When the messages of a log are due, at a multiple of the recorded pace. No clock: "now" is given.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "services/log-tool/log_event.hpp"
#include "services/log-tool/time_steps.hpp"

namespace markservo::log_tool {

class PlaySchedule {
 public:
  // `speed`: times the recorded pace, above 0. `longest_gap`: s of the log; where nothing was logged for longer, no
  // longer than that is waited.
  explicit PlaySchedule(double speed, double longest_gap = std::numeric_limits<double>::infinity())
      : speed_(speed), longest_gap_(longest_gap) {}

  // When the message recorded at `utime` is due, us of the clock of `now_us`, which is read just before. Each is due as
  // long after the one that began the time line as it was recorded, so that delays do not add up. Where the log's time
  // goes back by more than a second, or on by more than a day (see time_steps.hpp), a new time line begins at once.
  std::int64_t due_us(std::int64_t utime, std::int64_t now_us) {
    const double step_s = seconds_apart(last_utime_, utime);
    if (!begun_ || jumps(step_s)) {
      begun_ = true;
      first_utime_ = utime;
      first_us_ = now_us;
      left_out_s_ = 0.0;
    } else {
      left_out_s_ += std::max(0.0, step_s - longest_gap_);
    }
    last_utime_ = utime;
    return first_us_ + std::llround(1e6 * (seconds_apart(first_utime_, utime) - left_out_s_) / speed_);
  }

 private:
  double speed_;
  double longest_gap_;
  bool begun_ = false;
  std::int64_t first_utime_ = 0;
  std::int64_t last_utime_ = 0;
  std::int64_t first_us_ = 0;
  double left_out_s_ = 0.0;  // of gaps, since first_utime_
};

}  // namespace markservo::log_tool
