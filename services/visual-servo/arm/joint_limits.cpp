#include "services/visual-servo/arm/joint_limits.hpp"

#include <algorithm>

namespace markservo::visual_servo {

robot::JointVector inside_limits(const robot::ArmDescription& arm, const robot::JointVector& q) {
  robot::JointVector clamped = q;
  for (int i = 0; i < robot::kNumJoints; ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    clamped[i] = std::clamp(q[i], joint.min, joint.max);
  }
  return clamped;
}

robot::JointVector servo_speeds(const robot::ArmDescription& arm) {
  robot::JointVector speeds;
  for (int i = 0; i < robot::kNumJoints; ++i) speeds[i] = arm.joints[static_cast<std::size_t>(i)].speed;
  return speeds;
}

}  // namespace markservo::visual_servo
