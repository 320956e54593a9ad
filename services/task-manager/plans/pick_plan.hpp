#pragma once

// From a look to the end of the task: all that follows must be possible before anything moves.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "services/task-manager/parameters.hpp"
#include "services/task-manager/plans/approach_plan.hpp"
#include "services/task-manager/plans/posture_path.hpp"

namespace markservo::task_manager {

// Where the object is taken.
struct GripPlace {
  Eigen::Vector3d p_CT = Eigen::Vector3d::Zero();        // m, its mark, as looked at
  Eigen::Vector3d p_CG_first = Eigen::Vector3d::Zero();  // m, where the hand backs off to
  double standoff = 0.0;                                 // m, from the grip point back along y: where servoing begins
  double check_height = 0.0;                             // m, of the lift that verifies the grip
};

struct PickPlan {
  std::string trouble;  // why it cannot be taken: the verdict's name, then the reason; empty when it can
  std::vector<Move> approach;
  GripPlace place;
};

// Plans to pick the target whose mark is at `p_CT` (m) with the hand as it is now; `carry`: to the side table in the
// end. `robot` needs an arm and a manipulator mark, `target` a grip.
PickPlan plan_pick(const robot::RobotDescription& robot, const Parameters& parameters,
                   const robot::MarkDescription& target, const Eigen::Vector3d& p_CT, const HandState& hand,
                   bool carry);

}  // namespace markservo::task_manager
