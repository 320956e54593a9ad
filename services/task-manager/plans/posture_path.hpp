#pragma once

// Postures in a row along straight lines of the grip point, by inverse kinematics.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "common/robot/arm_kinematics.hpp"
#include "common/robot/robot_description.hpp"

namespace markservo::task_manager {

// One goal of a path.
struct Move {
  bool hold = false;  // stay where the arm is (only the gripper moves); else go to `q`
  robot::JointVector q = robot::JointVector::Zero();
  double speed = 0.0;    // m/s, limit of the grip point
  double opening = 0.0;  // m, of the gripper
  bool settle = true;    // come to rest; else being near is enough
  double dwell = 0.0;    // s, to wait there
};

// Builds a path from a posture. After the first point that cannot be reached it keeps why, and adds nothing.
class PosturePath {
 public:
  // `opening`: the gripper's at the start, m; `joint_margin`: rad inside the joints' limits.
  PosturePath(const robot::ArmDescription& arm, const robot::JointVector& start, double opening, double joint_margin);

  // Adds a straight line to `p_CG` (m), a posture at least every `step` (m); `settle`: coming to rest at its end.
  void line_to(const Eigen::Vector3d& p_CG, double step, double speed, bool settle = true);
  // Adds a turn about the column to this yaw (rad), radius and height kept.
  void turn_to(double yaw, double speed);
  // Adds a motion in joint space to `q` (rad); checks no limit.
  void joints_to(const robot::JointVector& q, double speed);
  // Adds a motion of the gripper to `opening` (m), and a wait of `dwell` (s).
  void gripper_to(double opening, double dwell);

  bool reachable() const { return trouble_.empty(); }
  // Why that point cannot be reached, with the numbers (robot::why_unreachable); empty where all can.
  const std::string& trouble() const { return trouble_; }
  const robot::JointVector& end() const { return end_; }
  Eigen::Vector3d end_point() const { return robot::grip_point(arm_, end_); }  // m in C
  const std::vector<Move>& moves() const { return moves_; }

 private:
  void add(const robot::JointVector& q, double speed, bool settle);

  const robot::ArmDescription& arm_;
  robot::JointVector end_;
  double opening_;
  double joint_margin_;
  std::string trouble_;
  std::vector<Move> moves_;
};

}  // namespace markservo::task_manager
