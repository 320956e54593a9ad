#include "services/task-manager/plans/approach_plan.hpp"

#include <algorithm>
#include <cmath>

#include "common/robot/workspace.hpp"

namespace markservo::task_manager {
namespace {

using robot::ArmDescription;

// A path that begins where the arm is, with the hand open at the end of its first move.
PosturePath begin_with_open_hand(const ArmDescription& arm, const Parameters& parameters, const HandState& hand) {
  PosturePath path(arm, hand.q, hand.opening, parameters.motion.joint_margin);
  const double open = arm.gripper.opening_max;
  path.gripper_to(open, hand.opening < open - parameters.grip.open_enough ? parameters.grip.open_time : 0.0);
  return path;
}

// Out of the row, straight back to depth `y` (m), or away from the side table along the arm's own direction.
void leave(PosturePath& path, const ArmDescription& arm, const MotionParameters& motion, double y) {
  const Eigen::Vector3d p_CG = path.end_point();
  if (std::abs(path.end()[0]) < motion.side_yaw) {
    if (p_CG.y() > y) path.line_to({p_CG.x(), y, p_CG.z()}, motion.near_step, motion.near_speed);
    return;
  }
  Eigen::Vector3d p_AG = robot::arm_base_pose(arm).inverse() * p_CG;
  const double radius = std::hypot(p_AG.x(), p_AG.y());
  if (radius > motion.side_retreat_radius) {
    p_AG.head<2>() *= motion.side_retreat_radius / radius;
    path.line_to(robot::arm_base_pose(arm) * p_AG, motion.near_step, motion.near_speed);
  }
  path.turn_to(0.0, motion.free_speed);
}

}  // namespace

const robot::MarkDescription* hand_mark_of(const robot::RobotDescription& robot) {
  for (const auto& mark : robot.marks) {
    if (mark.role == robot::MarkRole::kManipulator) return &mark;
  }
  return nullptr;
}

double visible_standoff(const robot::RobotDescription& robot, const Parameters& parameters,
                        const robot::MarkDescription& target, const Eigen::Vector3d& p_CT) {
  const double size = hand_mark_of(robot)->size;
  for (double s = parameters.approach.standoff_max; s > 0.0; s -= parameters.approach.standoff_step) {
    const Eigen::Vector3d p_CG = p_CT + target.grip->p_TG - Eigen::Vector3d(0.0, s, 0.0);
    const auto ik = robot::inverse_kinematics(*robot.arm, p_CG, parameters.motion.joint_margin);
    if (ik.status != robot::ReachStatus::kReachable) continue;
    const double margin = robot::view_margin_px(robot.cameras, robot::hand_mark_pose(*robot.arm, ik.q), size);
    if (margin >= robot.workspace.view_margin_px) return s;
  }
  return 0.0;
}

ApproachPlan plan_approach(const robot::RobotDescription& robot, const Parameters& parameters,
                           const robot::MarkDescription& target, const Eigen::Vector3d& p_CT, const HandState& hand) {
  const ArmDescription& arm = *robot.arm;
  const MotionParameters& motion = parameters.motion;
  const double before_front =
      target.grip->p_TG.y() + arm.gripper.finger_beyond_grip_point + parameters.approach.front_clearance;

  ApproachPlan plan;
  plan.standoff = visible_standoff(robot, parameters, target, p_CT);
  const Eigen::Vector3d p_CG = p_CT + target.grip->p_TG;
  plan.p_CG_first = p_CG - Eigen::Vector3d(0.0, std::max(plan.standoff, before_front), 0.0);

  PosturePath path = begin_with_open_hand(arm, parameters, hand);
  leave(path, arm, motion, plan.p_CG_first.y());
  const Eigen::Vector3d before = path.end_point();
  path.line_to({before.x(), std::min(before.y(), plan.p_CG_first.y()), plan.p_CG_first.z()}, motion.free_step,
               motion.free_speed);
  path.line_to(plan.p_CG_first, motion.free_step, motion.free_speed);
  path.line_to(p_CG - Eigen::Vector3d(0.0, plan.standoff, 0.0), motion.near_step, motion.near_speed);
  if (!path.reachable()) plan.trouble = "no way to a posture before the target: " + path.trouble();
  plan.moves = path.moves();
  return plan;
}

PosturePath plan_home(const ArmDescription& arm, const Parameters& parameters, const HandState& hand) {
  PosturePath path = begin_with_open_hand(arm, parameters, hand);
  leave(path, arm, parameters.motion, parameters.motion.retreat_y);
  path.joints_to(arm.home, parameters.motion.free_speed);
  return path;
}

}  // namespace markservo::task_manager
