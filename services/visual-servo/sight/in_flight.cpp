#include "services/visual-servo/sight/in_flight.hpp"

#include "common/robot/arm_kinematics.hpp"

namespace markservo::visual_servo {

Eigen::Vector3d seen_grip_point(const robot::ArmDescription& arm, const robot::JointVector& q_exposure,
                                const Eigen::Vector3d& p_CM) {
  return p_CM - robot::grip_pose(arm, q_exposure).linear() * arm.p_GM;
}

Eigen::Vector3d kinematic_bias(const robot::ArmDescription& arm, const robot::JointVector& q_exposure,
                               const Eigen::Vector3d& p_CM) {
  return p_CM - robot::hand_mark(arm, q_exposure);
}

Eigen::Vector3d predicted_grip_point(const robot::ArmDescription& arm, const robot::JointVector& q_command,
                                     const Eigen::Vector3d& bias) {
  return robot::grip_point(arm, q_command) + bias;
}

}  // namespace markservo::visual_servo
