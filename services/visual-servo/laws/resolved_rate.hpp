#pragma once

// Resolved-rate motion: the grip point goes straight towards its goal, within speed limits.

#include <Eigen/Core>

#include "common/robot/robot_description.hpp"

namespace markservo::visual_servo {

struct ResolvedRateParameters {
  double gain = 0.6;          // of what remains, per frame; settles in 4 frames, stable for a Jacobian wrong by 30%
  double damping = 0.01;      // m; the Jacobian's singular values are 0.08 to 0.35 m, so it costs 1% and tames the rest
  double joint_speed = 1.75;  // rad/s (100 degrees/s), a third of the servos' own: they follow without lag
  double grip_speed = 0.45;   // m/s; 15 cm in 0.35 s
  double grip_acceleration = 6.0;  // m/s^2; full speed after 3 frames, so that the arm is not kicked
};

// Joint step (rad) that moves the grip point by `grip_step` (m): damped least squares, J^T (J J^T + damping^2 I)^-1
// step, which stays small where the arm is stretched (C. W. Wampler, "Manipulator inverse kinematic solutions based on
// vector formulations and damped least-squares methods", IEEE Trans. SMC 16(1), 1986).
robot::JointVector damped_joint_step(const Eigen::Matrix3d& jacobian, const Eigen::Vector3d& grip_step, double damping);

// The next joint step (rad) of a grip point that still has `to_go` (m, in C) ahead, from the commanded posture
// `q_command`. `seconds`: frame interval; `grip_speed`: limit, m/s; `speed_before`: the grip point's last speed, m/s.
// Limits shorten the step and keep its direction.
robot::JointVector resolved_rate_step(const robot::ArmDescription& arm, const ResolvedRateParameters& parameters,
                                      const robot::JointVector& q_command, const Eigen::Vector3d& to_go, double seconds,
                                      double grip_speed, double speed_before);

}  // namespace markservo::visual_servo
