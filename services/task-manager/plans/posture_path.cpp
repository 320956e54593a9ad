#include "services/task-manager/plans/posture_path.hpp"

#include <fmt/core.h>

#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::task_manager {
namespace {

constexpr double kSamePoint = 0.0005;  // m: not worth a goal of its own

}  // namespace

PosturePath::PosturePath(const robot::ArmDescription& arm, const robot::JointVector& start, double opening,
                         double joint_margin)
    : arm_(arm), end_(start), opening_(opening), joint_margin_(joint_margin) {}

void PosturePath::add(const robot::JointVector& q, double speed, bool settle) {
  Move move;
  move.q = q;
  move.speed = speed;
  move.opening = opening_;
  move.settle = settle;
  moves_.push_back(move);
  end_ = q;
}

void PosturePath::line_to(const Eigen::Vector3d& p_CG, double step, double speed, bool settle) {
  const Eigen::Vector3d from = end_point();
  const double length = (p_CG - from).norm();
  if (length < kSamePoint) return;
  const int pieces = static_cast<int>(std::ceil(length / step));
  for (int i = 1; i <= pieces && reachable(); ++i) {
    const Eigen::Vector3d point = from + (p_CG - from) * (static_cast<double>(i) / pieces);
    const auto ik = robot::inverse_kinematics(arm_, point, joint_margin_);
    if (ik.status == robot::ReachStatus::kReachable) {
      add(ik.q, speed, settle && i == pieces);
    } else {
      trouble_ = robot::why_unreachable(arm_, point, joint_margin_);
    }
  }
}

void PosturePath::turn_to(double yaw, double speed) {
  if (!reachable()) return;
  const robot::JointDescription& joint = arm_.joints[0];
  if (yaw < joint.min || yaw > joint.max) {
    trouble_ = fmt::format("{}: {:.1f} degrees; allowed: {:.1f} to {:.1f} degrees",
                           robot::describe(robot::ReachStatus::kYawLimit), geometry::degrees(yaw),
                           geometry::degrees(joint.min), geometry::degrees(joint.max));
    return;
  }
  robot::JointVector q = end_;
  q[0] = yaw;
  add(q, speed, true);
}

void PosturePath::joints_to(const robot::JointVector& q, double speed) {
  if (reachable()) add(q, speed, true);
}

void PosturePath::gripper_to(double opening, double dwell) {
  if (!reachable()) return;
  opening_ = opening;
  // At the start the arm may rest beside its commanded posture: it shall not move for the gripper's sake.
  const bool nothing_yet = moves_.empty();
  add(end_, 0.0, true);
  moves_.back().hold = nothing_yet;
  moves_.back().dwell = dwell;
}

}  // namespace markservo::task_manager
