#include "services/visual-servo/laws/posture_motion.hpp"

#include <algorithm>
#include <cmath>

#include "common/robot/arm_kinematics.hpp"

namespace markservo::visual_servo {

robot::JointVector posture_step(const robot::ArmDescription& arm, const PostureMotionParameters& parameters,
                                const robot::JointVector& q_command, const robot::JointVector& q_goal, double seconds,
                                double grip_speed, double speed_before) {
  constexpr double kThere = 1e-9;  // rad
  const robot::JointVector to_go = q_goal - q_command;
  const double longest = to_go.cwiseAbs().maxCoeff();
  if (longest < kThere) return robot::JointVector::Zero();

  const double grip_per_joint = (robot::grip_point_jacobian(arm, q_command) * to_go).norm() / longest;  // m/rad
  const double brakes = std::sqrt(2.0 * parameters.joint_acceleration * longest);
  double speed = std::min({parameters.joint_speed, brakes, speed_before + parameters.joint_acceleration * seconds});
  if (grip_per_joint * speed > grip_speed) speed = grip_speed / grip_per_joint;
  return to_go * std::min(1.0, speed * seconds / longest);
}

}  // namespace markservo::visual_servo
