#pragma once

// What sight says that the joints do not: where the arm really stands, how long its links really are, and how far its
// shafts trail behind what the servos were told. Learned on the way by a Kalman filter, so that the entry into the goal
// is spoilt neither by one frame's noise nor by what was measured of a moving hand.
// A shaft trails by play + lag |v| + run_up v^2 against its direction: deadband and backlash, a controller's lag, and a
// motor that needs a way to gather speed and to brake.

#include <Eigen/Core>

#include "common/robot/robot_description.hpp"

namespace markservo::visual_servo {

struct KinematicBiasParameters {
  double offset_sigma = 0.01;     // m, a priori: where the arm stands
  double link_sigma = 0.002;      // m, a priori: 1% of a link of 0.2 m
  double sight_sigma = 0.0005;    // m, one frame's hand mark and the servos' small faults
  double play_sigma = 0.005;      // rad (0.3 degrees), a priori: a deadband, half a backlash
  double offset_drift = 0.00005;  // m per frame: deadband and backlash move the offset
  double lag_sigma = 0.010;       // s, a priori: by how much shafts trail behind the joints' word, as speed grows
  double run_up_sigma = 0.010;  // s^2/rad, a priori: 1 / (2 a) of motors that brake and gather speed at a = 50 rad/s^2
  double clock_sigma = 0.001;   // s between a picture and its joint states: a moving hand tells less
  // A frame that contradicts what was learned by so much in m and in sigmas is passed over; with a second one in a row
  // a joint's word was wrong before or is now, and what was learned by it is forgotten.
  double surprise = 0.005;
  double surprise_sigmas = 7.0;
};

// What the joints say of themselves at a frame's exposure.
struct JointMotion {
  robot::JointVector q;         // rad
  robot::JointVector speed;     // rad/s, by which they came there
  robot::JointVector trailing;  // part of its play by which each shaft trails, -1 to 1; 0: not known
};

class KinematicBias {
 public:
  // Takes one frame: the hand mark's centre `p_CM` (m) with the joints at its exposure.
  void observe(const robot::ArmDescription& arm, const KinematicBiasParameters& parameters, const JointMotion& joints,
               const Eigen::Vector3d& p_CM);

  // To be added to the kinematic grip point (m, in C) of a hand at rest in posture `q` (rad), where the shafts trail by
  // these parts of their play (each -1 to 1: the direction in which the joint arrived; 0 where nothing is known).
  Eigen::Vector3d at(const robot::ArmDescription& arm, const robot::JointVector& q,
                     const robot::JointVector& trailing) const;

  // Where the shafts are (rad) when the joints rest at `q` (rad) by their own word and trail by these parts of their
  // play, for all that is known of it: by these angles the grip point is told from the mark.
  robot::JointVector shafts(const robot::JointVector& q, const robot::JointVector& trailing) const;

  // By which a shaft trails behind a joint that turns on, rad, for all that is known.
  double play() const { return state_[kPlay]; }

 private:
  // The states' places: m, where the arm stands in C, and how much longer its links are; rad, s and s^2/rad, by which
  // shafts trail.
  enum Place { kOffset = 0, kUpperArm = 3, kForearm, kPlay, kLag, kRunUp, kStates };
  static constexpr int kStructure = kPlay;  // so many places tell of the arm, those behind of its shafts
  using Structure = Eigen::Matrix<double, 3, kStructure>;
  using Observation = Eigen::Matrix<double, 3, kStates>;
  using States = Eigen::Matrix<double, kStates, 1>;
  using Covariance = Eigen::Matrix<double, kStates, kStates>;

  void begin(const KinematicBiasParameters& parameters);
  static Structure by_structure(const robot::ArmDescription& arm, const robot::JointVector& q);
  static Observation observation(const robot::ArmDescription& arm, const JointMotion& joints);

  bool begun_ = false;
  bool contradicted_ = false;  // by the last frame, which was passed over
  States state_ = States::Zero();
  Covariance covariance_ = Covariance::Zero();
};

}  // namespace markservo::visual_servo
