#pragma once

// The path with the lifted object out of its row, to the side table, down, and away from it.

#include <string>

#include "services/task-manager/parameters.hpp"
#include "services/task-manager/plans/posture_path.hpp"

namespace markservo::task_manager {

// What is carried, and from where.
struct CarriedObject {
  Eigen::Vector3d p_CT_place = Eigen::Vector3d::Zero();    // m, its mark where it stood
  robot::JointVector q_grip = robot::JointVector::Zero();  // rad, where it was gripped
};

struct CarryPlan {
  std::string trouble;      // why there is none; empty when there is
  std::vector<Move> moves;  // ends above the side table's surface by place_gap, the hand still closed
  robot::JointVector end = robot::JointVector::Zero();
  double clearance = 0.0;  // m, least predicted distance to the neighbours and their support on the way
};

// The least distance (m) of the object, fixed to the hand since q_grip, to both its neighbours and the board under
// them, along `moves` from posture `start`, joints interpolated.
double path_clearance(const robot::ArmDescription& arm, const CarryParameters& parameters,
                      const robot::GripDescription& grip, const CarriedObject& object, const robot::JointVector& start,
                      const std::vector<Move>& moves);

// Plans from posture `start` (rad), the object lifted. Searches how far and in which direction to draw it out (straight
// back, along the arm, or between) for the widest clearance, since the hand turns as it comes nearer to the column.
CarryPlan plan_carry(const robot::ArmDescription& arm, const Parameters& parameters, const robot::GripDescription& grip,
                     const CarriedObject& object, const robot::JointVector& start, double opening);

// A path from where the object was put down: the hand opens and backs off along its own direction, then home.
PosturePath plan_release(const robot::ArmDescription& arm, const Parameters& parameters,
                         const robot::JointVector& start, double opening);

}  // namespace markservo::task_manager
