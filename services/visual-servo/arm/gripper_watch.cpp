#include "services/visual-servo/arm/gripper_watch.hpp"

#include <cmath>

namespace markservo::visual_servo {
namespace {

constexpr double kMoved = 0.0005;  // m, above the noise of a reported opening
constexpr double kRest_s = 0.3;    // the slowest gripper, 5 mm/s, opens or closes by three times kMoved in it

}  // namespace

void watch_gripper(const JointSample& sample, double commanded, std::int64_t commanded_since, bool obeying,
                   GripperWatch& watch) {
  const bool moved = !watch.seen || sample.session != watch.session || sample.utime < watch.rest_since ||
                     std::abs(sample.gripper_opening - watch.opening) > kMoved;
  if (moved) {
    watch = GripperWatch{true, sample.session, sample.gripper_opening, sample.utime, false};
  }
  if (!obeying) return;
  const bool at_rest = seconds_between(watch.rest_since, sample.utime) >= kRest_s &&
                       seconds_between(commanded_since, sample.utime) >= kRest_s;
  watch.pressing = commanded < sample.gripper_opening - kMoved && (sample.contact || at_rest);
}

}  // namespace markservo::visual_servo
