#pragma once

// The arm's geometry: yaw about the column, then shoulder and elbow in one vertical plane.
// Joints q (rad): q[0] about +z, counter-clockwise from above, 0 straight ahead; q[1] and q[2] raise when positive;
// q[2] is relative to the upper arm. Elbow up: q[2] <= 0. Frames as in config/robot.yaml.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::robot {

// Pose of the arm base A in the camera frame C.
Eigen::Isometry3d arm_base_pose(const ArmDescription& arm);

// Grip point G in C, m.
Eigen::Vector3d grip_point(const ArmDescription& arm, const JointVector& q);

// Pose of the forearm's axes (x right, y along the forearm, z across and up) with its origin at G, in C.
Eigen::Isometry3d grip_pose(const ArmDescription& arm, const JointVector& q);

// Centre of the hand mark M in C, m.
Eigen::Vector3d hand_mark(const ArmDescription& arm, const JointVector& q);

// Pose of the hand mark in C: x right and z up along its edges, y into it (its printed side faces -y).
Eigen::Isometry3d hand_mark_pose(const ArmDescription& arm, const JointVector& q);

// d p_CG / dq, m/rad.
Eigen::Matrix3d grip_point_jacobian(const ArmDescription& arm, const JointVector& q);

// Why inverse kinematics has no answer.
enum class ReachStatus {
  kReachable,
  kTooFar,    // beyond the stretched arm less its margin
  kTooClose,  // inside the folded arm
  kYawLimit,  // joint limits less the margin
  kShoulderLimit,
  kElbowLimit,
};

struct InverseKinematics {
  ReachStatus status = ReachStatus::kTooFar;
  JointVector q = JointVector::Zero();  // rad, valid when kReachable
};

// Joints that bring G to `p_CG` (m) with the elbow up, each at least `margin` (rad) inside its limits and the elbow as
// far from straight.
InverseKinematics inverse_kinematics(const ArmDescription& arm, const Eigen::Vector3d& p_CG, double margin);

// For people: "beyond the arm's reach", "beyond the yaw joint's limit", ...
const char* describe(ReachStatus status);

// Why inverse_kinematics() has no answer, with the numbers: "beyond the arm's reach: 0.412 m from the shoulder;
// allowed: 0.000 to 0.400 m"; empty where it has one.
std::string why_unreachable(const ArmDescription& arm, const Eigen::Vector3d& p_CG, double margin);

}  // namespace markservo::robot
