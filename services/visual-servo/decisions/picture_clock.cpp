#include "services/visual-servo/decisions/picture_clock.hpp"

#include <algorithm>

namespace markservo::visual_servo {
namespace {

constexpr double kNominalFrame_s = 1.0 / 30.0;
constexpr double kShortestFrame_s = 1.0 / 120.0;
constexpr double kLongestFrame_s = 0.1;  // a longer gap must not become a longer step
constexpr double kStands_s = 0.3;        // without a command, by then the arm stands: nothing is left to slow down from

}  // namespace

bool PictureClock::has_passed(const PoseSample& pose) const {
  return pose.frame_session == session_ && pose.utime <= utime_;
}

Succession PictureClock::advance(const PoseSample& pose) {
  const std::int64_t before = utime_;
  utime_ = pose.utime;
  if (pose.frame_session != session_) {
    session_ = pose.frame_session;
    seconds_ = kNominalFrame_s;
    return Succession::kOfAnotherWriter;
  }
  const double since = seconds_between(before, pose.utime);
  seconds_ = std::clamp(since, kShortestFrame_s, kLongestFrame_s);
  return since > kStands_s ? Succession::kAfterAGap : Succession::kNext;
}

void PictureClock::begin_anew() {
  session_ = 0;
  utime_ = 0;
}

}  // namespace markservo::visual_servo
