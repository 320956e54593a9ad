#include "services/task-manager/plans/lift_plan.hpp"

#include <algorithm>
#include <cmath>

#include "common/robot/workspace.hpp"

namespace markservo::task_manager {
namespace {

// How far the grip point must go in x so that the middle of an object that has turned with the hand is where it was.
double way_aside(const robot::ArmDescription& arm, const Eigen::Vector3d& p_CG, double object_middle) {
  const Eigen::Vector2d p_CA = robot::arm_base_pose(arm).translation().head<2>();
  double aside = 0.0;
  for (int i = 0; i < 3; ++i) {  // the hand's direction changes a little with the way
    const Eigen::Vector2d hand = p_CG.head<2>() + Eigen::Vector2d(aside, 0.0) - p_CA;
    aside = -object_middle * hand.normalized().x();
  }
  return aside;
}

}  // namespace

double closed_opening(const GripParameters& parameters, const robot::GripDescription& grip) {
  return std::max(0.0, grip.object_width - parameters.squeeze);
}

PosturePath plan_lift(const robot::ArmDescription& arm, const Parameters& parameters,
                      const robot::GripDescription& grip, const robot::JointVector& start,
                      const Eigen::Vector3d& p_CG_place, double height, double opening) {
  constexpr double kBendStep = 0.001;    // m
  constexpr double kHeightStep = 0.004;  // m: small, so that the way is straight
  PosturePath path(arm, start, opening, parameters.motion.joint_margin);
  const double z_end = p_CG_place.z() + height;
  const int pieces = std::max(1, static_cast<int>(std::ceil((z_end - path.end_point().z()) / kHeightStep)));
  const double z_start = path.end_point().z();
  const double object_middle = 0.5 * parameters.carry.object.depth - grip.p_TG.y();  // m, behind the grip point
  const double aside = way_aside(arm, p_CG_place, object_middle);
  const double turning = std::max(1e-6, parameters.lift.check_height - parameters.lift.free_height);
  double bend = std::max(0.0, p_CG_place.y() - path.end_point().y());
  for (int i = 1; i <= pieces && path.reachable(); ++i) {
    Eigen::Vector3d point = p_CG_place;
    point.z() = z_start + (z_end - z_start) * (static_cast<double>(i) / pieces);
    point.x() += aside * std::clamp((point.z() - p_CG_place.z() - parameters.lift.free_height) / turning, 0.0, 1.0);
    const auto reachable = [&](double back) {
      const Eigen::Vector3d bent = point - Eigen::Vector3d(0.0, back, 0.0);
      return robot::inverse_kinematics(arm, bent, parameters.motion.joint_margin).status ==
             robot::ReachStatus::kReachable;
    };
    while (!reachable(bend) && bend < parameters.lift.bend_max) bend += kBendStep;
    point.y() -= bend;
    path.line_to(point, 2.0 * kHeightStep, parameters.motion.lift_speed, i == pieces);
  }
  return path;
}

PosturePath plan_put_back(const robot::ArmDescription& arm, const Parameters& parameters,
                          const robot::JointVector& start, const Eigen::Vector3d& p_CG_place,
                          const Eigen::Vector3d& p_CG_back, double opening) {
  const MotionParameters& motion = parameters.motion;
  PosturePath path(arm, start, opening, motion.joint_margin);
  path.line_to(p_CG_place, motion.near_step, motion.lift_speed);
  path.gripper_to(arm.gripper.opening_max, parameters.grip.open_time);
  path.line_to(p_CG_back, motion.near_step, motion.near_speed);
  return path;
}

double check_height(const robot::RobotDescription& robot, const Parameters& parameters,
                    const robot::MarkDescription& target, const Eigen::Vector3d& p_CT) {
  constexpr double kStep = 0.001;  // m
  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();
  double height = parameters.lift.check_height;
  for (; height > parameters.lift.check_height_min; height -= kStep) {
    X_CT.translation() = p_CT + Eigen::Vector3d(0.0, 0.0, height);
    if (robot::view_margin_px(robot.cameras, X_CT, target.size) >= 0.5 * robot.workspace.view_margin_px) break;
  }
  return std::max(height, parameters.lift.check_height_min);
}

}  // namespace markservo::task_manager
