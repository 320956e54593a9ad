#include "services/visual-servo/arm/goal_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/geometry/degrees.hpp"
#include "common/robot/arm_kinematics.hpp"

namespace markservo::visual_servo {
namespace {

using geometry::kDegreesPerRadian;

bool finite(const Goal& goal) {
  bool ok = goal.p_TG_C.allFinite() && std::isfinite(goal.tolerance) && std::isfinite(goal.speed) &&
            std::isfinite(goal.gripper_opening) && std::isfinite(goal.gripper_force);
  for (const double q : goal.position) ok = ok && std::isfinite(q);
  return ok;
}

std::string why_posture_is_refused(const robot::ArmDescription& arm, const Goal& goal) {
  if (goal.position.size() != arm.joints.size()) {
    return fmt::format("posture has {} joints, the arm has {}", goal.position.size(), arm.joints.size());
  }
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const auto& joint = arm.joints[i];
    if (goal.position[i] < joint.min || goal.position[i] > joint.max) {
      return fmt::format("posture: joint {} at {:.1f} deg, allowed {:.1f} to {:.1f} deg", joint.name,
                         goal.position[i] * kDegreesPerRadian, joint.min * kDegreesPerRadian,
                         joint.max * kDegreesPerRadian);
    }
  }
  return "";
}

std::string why_target_is_refused(const robot::RobotDescription& robot, const Goal& goal) {
  const auto* mark = robot.find_mark(goal.target);
  if (mark != nullptr && mark->role == robot::MarkRole::kTarget) return "";
  std::string known;
  for (const auto& candidate : robot.marks) {
    if (candidate.role == robot::MarkRole::kTarget) known += (known.empty() ? "" : ", ") + candidate.name;
  }
  return "target '" + goal.target + "' is not a target in robot.yaml, allowed: " + known;
}

std::string why_limit(const robot::ArmDescription& arm, std::size_t joint, double angle, double margin) {
  const auto& limits = arm.joints[joint];
  return fmt::format("joint {} would be at {:.1f} deg, allowed {:.1f} to {:.1f} deg", limits.name,
                     angle * kDegreesPerRadian, (limits.min + margin) * kDegreesPerRadian,
                     (limits.max - margin) * kDegreesPerRadian);
}

}  // namespace

std::string why_goal_is_refused(const robot::RobotDescription& robot, const Goal& goal) {
  if (goal.kind == GoalKind::kUnknown) return "goal of unknown kind";
  if (!finite(goal)) return "goal holds a number that is not finite";
  if (goal.tolerance < 0.0) return fmt::format("tolerance is {:g} m, allowed 0 or more", goal.tolerance);
  if (goal.speed < 0.0) return fmt::format("speed is {:g} m/s, allowed 0 or more", goal.speed);
  if (goal.kind == GoalKind::kPosture) return why_posture_is_refused(*robot.arm, goal);
  if (goal.kind == GoalKind::kServo) return why_target_is_refused(robot, goal);
  return "";
}

std::string why_unreachable(const robot::ArmDescription& arm, const Eigen::Vector3d& p_CG, double margin,
                            JointVector& q) {
  const robot::InverseKinematics ik = robot::inverse_kinematics(arm, p_CG, margin);
  q = ik.q;
  if (ik.status == robot::ReachStatus::kReachable) return "";
  const Eigen::Vector3d p_AG = robot::arm_base_pose(arm).inverse() * p_CG;
  const double across = std::hypot(p_AG.x(), p_AG.y());
  const double shoulder_to_goal = std::hypot(across, p_AG.z() - arm.column);
  const std::string where = fmt::format("grip point ({:.3f}, {:.3f}, {:.3f}) m: ", p_CG.x(), p_CG.y(), p_CG.z());
  switch (ik.status) {
    case robot::ReachStatus::kTooFar:
      return where + fmt::format("{:.3f} m from the shoulder, the arm reaches {:.3f} m", shoulder_to_goal,
                                 arm.upper_arm + arm.forearm);
    case robot::ReachStatus::kTooClose:
      return where + fmt::format("{:.3f} m from the shoulder, too close", shoulder_to_goal);
    case robot::ReachStatus::kYawLimit:
      return where + why_limit(arm, 0, ik.q[0], margin);
    case robot::ReachStatus::kShoulderLimit:
      return where + why_limit(arm, 1, ik.q[1], margin);
    case robot::ReachStatus::kElbowLimit:
      return where + why_limit(arm, 2, ik.q[2], margin);
    case robot::ReachStatus::kReachable:
      break;
  }
  return "";
}

}  // namespace markservo::visual_servo
