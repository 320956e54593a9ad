#pragma once

// Did the object come along with the hand? Told from both marks before and after a small lift.

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::task_manager {

// Mean of a mark's position over frames; each frame counts once.
class MarkAverage {
 public:
  void add(std::int64_t frame_utime, const Eigen::Vector3d& p_C);
  int count() const { return count_; }
  std::int64_t last_utime() const { return last_utime_; }
  Eigen::Vector3d mean() const;  // m; zero when empty

 private:
  int count_ = 0;
  std::int64_t last_utime_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
};

struct LiftView {
  Eigen::Vector3d p_CT = Eigen::Vector3d::Zero();     // m, target mark
  Eigen::Vector3d p_CM = Eigen::Vector3d::Zero();     // m, hand mark
  robot::JointVector q = robot::JointVector::Zero();  // rad
};

struct LiftVerdict {
  bool came_along = false;
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  // m, the target mark's place less the nearest one with the hand
  std::string reason;                               // figures for people
};

struct LiftDemand {
  double height = 0.0;      // m, by which the grip point was to rise
  double tolerance = 0.0;   // m, largest |error| that counts as coming along
  double rise_share = 0.0;  // of what kinematics predicts: the least that either mark rises
};

// An object between two pads goes where the hand goes, and turns about the grip point by anything from nothing (it
// hangs) to the hand's own turn (it is held fast). `error` is to the nearest of these places; all are told from the
// hand's mark, so that a wrong calibration cancels, but for its turn (10 mm and 3 degrees: 0.5 mm). A scene in which
// nothing moved would pass as well: the grip point by the joints must have risen, and both marks with it.
LiftVerdict check_lift(const robot::ArmDescription& arm, const LiftView& before, const LiftView& after,
                       const LiftDemand& demand);

}  // namespace markservo::task_manager
