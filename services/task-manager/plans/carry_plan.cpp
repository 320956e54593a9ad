#include "services/task-manager/plans/carry_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "services/task-manager/plans/box_clearance.hpp"

namespace markservo::task_manager {
namespace {

// The object standing at its place, its mark at `p_CT`.
Box standing_object(const CarryParameters& carry, double width, const Eigen::Vector3d& p_CT) {
  Box box;
  box.half_size << 0.5 * width, 0.5 * carry.object.depth, 0.5 * (carry.object.above_mark + carry.object.below_mark);
  box.X_CB.translation() =
      p_CT + Eigen::Vector3d(0.0, 0.5 * carry.object.depth, 0.5 * (carry.object.above_mark - carry.object.below_mark));
  return box;
}

// The neighbours and the board they stand on.
std::vector<Box> obstacles(const CarryParameters& carry, const robot::GripDescription& grip,
                           const Eigen::Vector3d& p_CT) {
  std::vector<Box> boxes;
  for (const double side : {-1.0, 1.0}) {
    boxes.push_back(standing_object(carry, grip.object_width, p_CT + Eigen::Vector3d(side * grip.spacing, 0.0, 0.0)));
  }
  constexpr double kBoardThickness = 0.02;  // m
  Box board;
  board.half_size << carry.support_half_width, 0.5 * (carry.object.depth + carry.support_front), 0.5 * kBoardThickness;
  board.X_CB.translation() = p_CT + Eigen::Vector3d(0.0, 0.5 * (carry.object.depth - carry.support_front),
                                                    -carry.object.below_mark - 0.5 * kBoardThickness);
  boxes.push_back(board);
  return boxes;
}

// At `radius` (m) from the column in direction `yaw` (rad), height z (m) in C.
Eigen::Vector3d around_column(const robot::ArmDescription& arm, double radius, double yaw, double z) {
  const Eigen::Vector3d p_AG(-radius * std::sin(yaw), radius * std::cos(yaw), z - arm.p_CA.z());
  return robot::arm_base_pose(arm) * p_AG;
}

double radius_of(const robot::ArmDescription& arm, const Eigen::Vector3d& p_CG) {
  return (robot::arm_base_pose(arm).inverse() * p_CG).head<2>().norm();
}

}  // namespace

double path_clearance(const robot::ArmDescription& arm, const CarryParameters& parameters,
                      const robot::GripDescription& grip, const CarriedObject& object, const robot::JointVector& start,
                      const std::vector<Move>& moves) {
  constexpr double kSample = 0.02;  // rad between the postures looked at
  const std::vector<Box> boxes = obstacles(parameters, grip, object.p_CT_place);
  Box carried = standing_object(parameters, grip.object_width, object.p_CT_place);
  const Eigen::Isometry3d X_GB = robot::grip_pose(arm, object.q_grip).inverse() * carried.X_CB;

  double least = std::numeric_limits<double>::infinity();
  robot::JointVector from = start;
  for (const Move& move : moves) {
    const int samples = 1 + static_cast<int>((move.q - from).cwiseAbs().maxCoeff() / kSample);
    for (int i = 1; i <= samples; ++i) {
      carried.X_CB = robot::grip_pose(arm, from + (move.q - from) * (static_cast<double>(i) / samples)) * X_GB;
      for (const Box& box : boxes) least = std::min(least, box_clearance(carried, box));
    }
    from = move.q;
  }
  return least;
}

CarryPlan plan_carry(const robot::ArmDescription& arm, const Parameters& parameters, const robot::GripDescription& grip,
                     const CarriedObject& object, const robot::JointVector& start, double opening) {
  const CarryParameters& carry = parameters.carry;
  const MotionParameters& motion = parameters.motion;
  constexpr double kRetractStep = 0.01;  // m
  const Eigen::Vector3d p_CG = robot::grip_point(arm, start);
  const Eigen::Vector3d p_CG_grip = robot::grip_point(arm, object.q_grip);
  const Eigen::Vector3d column = arm.p_CA;
  // The forearm's pitch at the grip is nearly that of the same height and radius elsewhere: so the object stands
  // upright.
  const double place_radius = std::clamp(radius_of(arm, p_CG_grip), carry.place_radius_min, carry.place_radius_max);
  const double place_z = p_CG_grip.z() + carry.place_height + carry.place_gap;

  CarryPlan best;
  best.clearance = -std::numeric_limits<double>::infinity();
  std::string unreachable;  // of the way that was tried last
  for (double back = carry.retract_min; back < carry.retract_max + 0.5 * kRetractStep; back += kRetractStep) {
    for (const double along_arm : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double slope = (p_CG.x() - column.x()) / std::max(0.01, p_CG.y() - column.y());
      PosturePath path(arm, start, opening, motion.joint_margin);
      path.line_to(p_CG - back * Eigen::Vector3d(along_arm * slope, 1.0, 0.0), motion.near_step, motion.near_speed);
      path.turn_to(carry.place_yaw, motion.near_speed);
      const double z = path.end_point().z();
      path.line_to(around_column(arm, place_radius, carry.place_yaw, z), motion.near_step, motion.near_speed);
      path.line_to(around_column(arm, place_radius, carry.place_yaw, place_z), motion.near_step, motion.lift_speed);
      if (!path.reachable()) {
        unreachable = path.trouble();
        continue;
      }
      const double clearance = path_clearance(arm, carry, grip, object, start, path.moves());
      if (clearance > best.clearance) {
        best.clearance = clearance;
        best.moves = path.moves();
        best.end = path.end();
      }
    }
  }
  if (best.moves.empty()) {
    best.trouble = "the way to the side table is " + unreachable;
  } else if (best.clearance < carry.clearance) {
    best.trouble = fmt::format("on the way out it would come within {:.1f} mm of its neighbours, allowed: {:.1f} mm",
                               1000.0 * best.clearance, 1000.0 * carry.clearance);
  }
  return best;
}

PosturePath plan_release(const robot::ArmDescription& arm, const Parameters& parameters,
                         const robot::JointVector& start, double opening) {
  const MotionParameters& motion = parameters.motion;
  PosturePath path(arm, start, opening, motion.joint_margin);
  path.gripper_to(arm.gripper.opening_max, parameters.grip.open_time);
  const Eigen::Vector3d p_CG = path.end_point();
  const double radius = std::max(motion.side_retreat_radius, radius_of(arm, p_CG) - parameters.carry.leave_distance);
  path.line_to(around_column(arm, radius, start[0], p_CG.z()), motion.near_step, motion.near_speed);
  return path;
}

}  // namespace markservo::task_manager
