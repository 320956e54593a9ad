#pragma once

// Straight up with the gripped object, and down again.

#include "services/task-manager/parameters.hpp"
#include "services/task-manager/plans/posture_path.hpp"

namespace markservo::task_manager {

// m, what the gripper is told to close to around an object.
double closed_opening(const GripParameters& parameters, const robot::GripDescription& grip);

// A path from posture `start` (rad) up until the grip point is `height` (m) above `p_CG_place` (m). Where the arm does
// not reach straight up, the path bends towards the robot, at most bend_max. A hand that comes from the side turns the
// object with it once it hangs: the path gives way to the other side, so that the object's middle stays between its
// neighbours. The gripper stays closed at `opening` (m).
PosturePath plan_lift(const robot::ArmDescription& arm, const Parameters& parameters,
                      const robot::GripDescription& grip, const robot::JointVector& start,
                      const Eigen::Vector3d& p_CG_place, double height, double opening);

// A path from posture `start` down to `p_CG_place` (m), then the hand opens and goes back to `p_CG_back` (m) on
// straight lines.
PosturePath plan_put_back(const robot::ArmDescription& arm, const Parameters& parameters,
                          const robot::JointVector& start, const Eigen::Vector3d& p_CG_place,
                          const Eigen::Vector3d& p_CG_back, double opening);

// How high (m, check_height_min to check_height) the object at `p_CT` can be lifted with its mark in both images.
double check_height(const robot::RobotDescription& robot, const Parameters& parameters,
                    const robot::MarkDescription& target, const Eigen::Vector3d& p_CT);

}  // namespace markservo::task_manager
