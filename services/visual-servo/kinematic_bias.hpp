#pragma once

// What sight says that the joints do not: where the arm really stands and how long its links really are, learned on the
// way by a Kalman filter, so that the entry into the goal is not spoilt by one frame's noise.

#include <Eigen/Core>

#include "common/robot/robot_description.hpp"

namespace markservo::visual_servo {

struct KinematicBiasParameters {
  double offset_sigma = 0.01;    // m, a priori: where the arm stands
  double link_sigma = 0.002;     // m, a priori: 1% of a link of 0.2 m
  double sight_sigma = 0.0005;   // m, one frame's hand mark and the servos' small faults
  double offset_drift = 0.0002;  // m per frame: deadband and backlash move the offset
  double clock_sigma = 0.003;    // s between a picture and its joint states: a moving hand tells less
};

class KinematicBias {
 public:
  // Takes one frame: the hand mark's centre `p_CM` (m) with the joints at its exposure (rad); the grip point moved at
  // `grip_speed` (m/s).
  void see(const robot::ArmDescription& arm, const KinematicBiasParameters& parameters,
           const robot::JointVector& q_exposure, const Eigen::Vector3d& p_CM, double grip_speed);

  // To be added to the kinematic grip point (m, in C) at posture `q`.
  Eigen::Vector3d at(const robot::ArmDescription& arm, const robot::JointVector& q) const;

 private:
  using Vector5 = Eigen::Matrix<double, 5, 1>;
  using Matrix5 = Eigen::Matrix<double, 5, 5>;
  bool begun_ = false;
  Vector5 state_ = Vector5::Zero();  // m: offset in C, upper arm, forearm
  Matrix5 covariance_ = Matrix5::Zero();
};

}  // namespace markservo::visual_servo
