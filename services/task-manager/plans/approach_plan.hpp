#pragma once

// From wherever the hand is to a posture before the target, and back from it, never through the other objects of its
// row.

#include <string>
#include <vector>

#include "services/task-manager/parameters.hpp"
#include "services/task-manager/plans/posture_path.hpp"

namespace markservo::task_manager {

struct ApproachPlan {
  std::string trouble;      // why there is none; empty when there is
  std::vector<Move> moves;  // ends at `standoff`, the hand open
  double standoff = 0.0;    // m, from the grip point back along y: where servoing begins
  Eigen::Vector3d p_CG_first =
      Eigen::Vector3d::Zero();  // m, the posture before the objects' fronts, to which the hand backs off
};

// Where the arm is and how far its gripper is open (m).
struct HandState {
  robot::JointVector q = robot::JointVector::Zero();
  double opening = 0.0;
};

// The largest standoff (m) in [0, standoff_max] from which the hand's mark is predicted wholly inside both images and
// the arm reaches; 0 if there is none larger. `robot` needs an arm and a manipulator mark, `target` a grip.
double visible_standoff(const robot::RobotDescription& robot, const Parameters& parameters,
                        const robot::MarkDescription& target, const Eigen::Vector3d& p_CT);

// A path to the visible standoff before the target whose mark is at `p_CT` (m). Opens the hand first, leaves the row
// or the side table straight, goes up before the shelf, and passes the objects' fronts only on the line of approach.
ApproachPlan plan_approach(const robot::RobotDescription& robot, const Parameters& parameters,
                           const robot::MarkDescription& target, const Eigen::Vector3d& p_CT, const HandState& hand);

// A path home: the hand is opened if it is not, leaves the row or the side table straight, then folds. Not reachable
// only from postures outside the arm's limits.
PosturePath plan_home(const robot::ArmDescription& arm, const Parameters& parameters, const HandState& hand);

// The robot's mark of role manipulator, or null.
const robot::MarkDescription* hand_mark_of(const robot::RobotDescription& robot);

}  // namespace markservo::task_manager
