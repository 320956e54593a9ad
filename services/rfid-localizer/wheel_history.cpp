#include "services/rfid-localizer/wheel_history.hpp"

namespace markservo::rfid_localizer {

void WheelHistory::add(std::int64_t utime, const WheelMotion& motion) {
  samples_.push_back({utime, motion});
  while (samples_.size() > 2 && samples_[1].utime < utime - kKept_us) samples_.pop_front();
}

WheelMotion WheelHistory::rate(std::int64_t from, std::int64_t to) const {
  WheelMotion sum;
  replay(from, to, [&sum](const WheelMotion& piece) {
    sum.way += piece.way;
    sum.turn += piece.turn;
    sum.time += piece.time;
  });
  if (sum.time <= 0.0) return {};
  return {sum.way / sum.time, sum.turn / sum.time, 1.0, 0.0};
}

}  // namespace markservo::rfid_localizer
