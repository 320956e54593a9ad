#pragma once

// The two marks of a SERVO goal: the target's, averaged while it stands still, and the hand's, believed only near where
// the joints say it is.

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "services/visual-servo/servo_types.hpp"
#include "services/visual-servo/sight/still_target.hpp"

namespace markservo::visual_servo {

struct HandAndTargetParameters {
  StillTargetParameters target;
  double hand_mismatch = 0.04;  // m between the hand mark and where the joints say it is: another thing was seen
};

// Where both stand at one frame's exposure.
struct Sighting {
  std::string lost;                                // why that is not known, for people; all below is valid when empty
  std::int64_t utime = 0;                          // us, of the exposure
  JointVector q_exposure = JointVector::Zero();    // rad
  Eigen::Vector3d p_CM = Eigen::Vector3d::Zero();  // m, hand mark
  Eigen::Matrix3d hand_covariance = Eigen::Matrix3d::Zero();    // m^2
  Eigen::Vector3d p_CT = Eigen::Vector3d::Zero();               // m, target mark
  Eigen::Matrix3d target_covariance = Eigen::Matrix3d::Zero();  // m^2
};

class HandAndTarget {
 public:
  // Takes in one frame, with the joints at its exposure (rad). `hand` and `target`: the marks' names.
  Sighting observe(const HandAndTargetParameters& parameters, const robot::ArmDescription& arm, const PoseSample& pose,
                   const JointVector& q_exposure, const std::string& hand, const std::string& target);
  // To be called for another target, and when the pictures are of another writer.
  void forget() { target_.forget(); }

 private:
  StillTarget target_;
};

}  // namespace markservo::visual_servo
