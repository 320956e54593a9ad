#include "common/robot/workspace.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "common/robot/arm_kinematics.hpp"

namespace markservo::robot {
namespace {

// The least room, m, between the open fingers and the objects beside and between them. The objects stand along C's y;
// the fingers reach from the object's front to the fingertip, turned by the arm's yaw.
double finger_room(const ArmDescription& arm, const GripDescription& grip, const JointVector& q) {
  const double yaw = arm.yaw_CA + q[0];
  const double inner = 0.5 * arm.gripper.opening_max;
  const double outer = inner + arm.gripper.finger_thickness;
  double room = std::numeric_limits<double>::infinity();
  // Along the fingers, horizontally: from where they pass the front to their tips.
  for (const double along : {-grip.p_TG.y(), arm.gripper.finger_beyond_grip_point}) {
    for (const double side : {-1.0, 1.0}) {
      const double shift = side * -std::sin(yaw) * along;
      room = std::min(room, std::cos(yaw) * inner + shift - 0.5 * grip.object_width);
      room = std::min(room, grip.spacing - 0.5 * grip.object_width - (std::cos(yaw) * outer + shift));
    }
  }
  return room;
}

const MarkDescription& manipulator_mark(const RobotDescription& robot) {
  for (const auto& mark : robot.marks) {
    if (mark.role == MarkRole::kManipulator) return mark;
  }
  throw std::invalid_argument("judge_grip: the robot has no mark of role manipulator");
}

}  // namespace

double view_margin_px(const CameraDescription& cameras, const Eigen::Isometry3d& X_CM, double size) {
  double margin = std::numeric_limits<double>::infinity();
  for (const double along_x : {-0.5, 0.5}) {
    for (const double along_z : {-0.5, 0.5}) {
      const auto point = geometry::project(cameras.stereo, X_CM * Eigen::Vector3d(along_x * size, 0.0, along_z * size));
      if (!point) return -std::numeric_limits<double>::infinity();
      for (const double u : {point->u_left, point->u_right}) {
        margin = std::min({margin, u + 0.5, cameras.width - 0.5 - u});
      }
      margin = std::min({margin, point->v + 0.5, cameras.height - 0.5 - point->v});
    }
  }
  return margin;
}

GripJudgement judge_grip(const RobotDescription& robot, const MarkDescription& target, const Eigen::Vector3d& p_CT) {
  if (!robot.arm) throw std::invalid_argument("judge_grip: the robot has no arm");
  if (!target.grip) throw std::invalid_argument("judge_grip: mark '" + target.name + "' has no grip");
  const ArmDescription& arm = *robot.arm;
  const MarkDescription& hand = manipulator_mark(robot);

  const Eigen::Vector3d p_CG = p_CT + target.grip->p_TG;
  const InverseKinematics ik = inverse_kinematics(arm, p_CG, robot.workspace.joint_margin);
  if (ik.status != ReachStatus::kReachable) {
    return {GripVerdict::kUnreachable, why_unreachable(arm, p_CG, robot.workspace.joint_margin)};
  }

  const double room = finger_room(arm, *target.grip, ik.q);
  if (room < robot.workspace.finger_clearance) {
    return {GripVerdict::kUnreachable,
            fmt::format("the fingers have {:.1f} mm of room between the objects, less than {:.1f} mm", 1000.0 * room,
                        1000.0 * robot.workspace.finger_clearance)};
  }

  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();
  X_CT.translation() = p_CT;
  const double target_margin = view_margin_px(robot.cameras, X_CT, target.size);
  if (target_margin < robot.workspace.view_margin_px) {
    return {GripVerdict::kOutOfView, "the mark of " + target.name + " is not wholly inside both images"};
  }
  const double hand_margin = view_margin_px(robot.cameras, hand_mark_pose(arm, ik.q), hand.size);
  if (hand_margin < robot.workspace.view_margin_px) {
    return {GripVerdict::kOutOfView, "the hand's mark would not be wholly inside both images at the grip"};
  }
  return {GripVerdict::kFeasible, ""};
}

const char* name_of(GripVerdict verdict) {
  switch (verdict) {
    case GripVerdict::kFeasible:
      return "feasible";
    case GripVerdict::kUnreachable:
      return "unreachable";
    case GripVerdict::kOutOfView:
      return "out_of_view";
  }
  return "unknown";
}

}  // namespace markservo::robot
