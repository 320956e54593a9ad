#include "services/visual-servo/laws/resolved_rate.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "common/robot/arm_kinematics.hpp"
#include "services/visual-servo/arm/joint_limits.hpp"

namespace markservo::visual_servo {

robot::JointVector damped_joint_step(const Eigen::Matrix3d& jacobian, const Eigen::Vector3d& grip_step,
                                     double damping) {
  const Eigen::Matrix3d damped = jacobian * jacobian.transpose() + damping * damping * Eigen::Matrix3d::Identity();
  return jacobian.transpose() * damped.inverse() * grip_step;
}

robot::JointVector resolved_rate_step(const robot::ArmDescription& arm, const ResolvedRateParameters& parameters,
                                      const robot::JointVector& q_command, const Eigen::Vector3d& to_go, double seconds,
                                      double grip_speed, double speed_before) {
  Eigen::Vector3d grip_step = parameters.gain * to_go;
  const double allowed_speed = std::min(grip_speed, speed_before + parameters.grip_acceleration * seconds);
  const double allowed = allowed_speed * seconds;
  if (grip_step.norm() > allowed) grip_step *= allowed / grip_step.norm();

  robot::JointVector joint_step =
      damped_joint_step(robot::grip_point_jacobian(arm, q_command), grip_step, parameters.damping);
  const double joint_allowed = parameters.joint_speed * seconds;
  const double largest = joint_step.cwiseAbs().maxCoeff();
  if (largest > joint_allowed) joint_step *= joint_allowed / largest;
  return inside_limits(arm, q_command + joint_step) - q_command;
}

}  // namespace markservo::visual_servo
