#pragma once

// Does the gripper press on something? Told from its reports and from what it was commanded, so that a stop neither
// drops what is held nor lets a hand that was still moving go on after the reset.

#include <cstdint>

#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

struct GripperWatch {
  bool seen = false;
  std::int64_t session = 0;     // of the joint states
  double opening = 0.0;         // m, at which it has rested
  std::int64_t rest_since = 0;  // us
  bool pressing = false;        // it rests or touches, though it is commanded to close further
};

// Takes in one joint state. `commanded` (m) is what the gripper has been told since `commanded_since` (us). While the
// arm is not `obeying` (stopped, or not taken up again yet) nobody begins to press; who moves does not press any more.
void watch_gripper(const JointSample& sample, double commanded, std::int64_t commanded_since, bool obeying,
                   GripperWatch& watch);

}  // namespace markservo::visual_servo
