#pragma once

// From the encoders' wrapping counters to motion, and what cannot be true of them.

#include <cstdint>
#include <optional>
#include <string>

#include "common/robot/robot_description.hpp"
#include "services/rfid-localizer/wheel_history.hpp"

namespace markservo::rfid_localizer {

struct EncoderReading {
  std::int64_t utime = 0;    // us
  std::int64_t session = 0;  // of the driver: another one when it restarted, with counters from anywhere
  std::int32_t left_ticks = 0;
  std::int32_t right_ticks = 0;
};

class EncoderCounters {
 public:
  explicit EncoderCounters(const robot::BaseDescription& base);

  // The motion since the last reading; nothing for the first one. A driver's restart, a jump of the counters and a gap
  // in which they may have wrapped around unseen give no motion but an unknown way. Throws std::invalid_argument, and
  // keeps what it had, when time does not go on.
  std::optional<WheelMotion> motion(const EncoderReading& reading);

  // The next reading is the first one.
  void forget() {
    last_.reset();
    play_ = 0.0;
  }

  std::int64_t jumps() const { return jumps_; }  // refused ones, since the start

 private:
  std::int64_t difference(std::int32_t newer, std::int32_t older) const;
  // Of a `turn` (rad), what is more than the ticks' jitter.
  double turning(double turn);

  robot::BaseDescription base_;
  std::optional<EncoderReading> last_;
  double play_ = 0.0;  // rad, of the heading against its dead band's middle
  std::int64_t jumps_ = 0;
};

}  // namespace markservo::rfid_localizer
