#include "services/visual-servo/sight/kinematic_bias.hpp"

#include <Eigen/LU>
#include <cmath>

#include "common/robot/arm_kinematics.hpp"
#include "services/visual-servo/sight/in_flight.hpp"

namespace markservo::visual_servo {
namespace {

double squared(double sigma) {
  return sigma * sigma;
}

// How the hand's mark moves at joint speeds `speed` (rad/s), m/s.
Eigen::Vector3d hand_velocity(const robot::ArmDescription& arm, const robot::JointVector& q,
                              const robot::JointVector& speed) {
  constexpr double kSpan_s = 1e-4;
  return (robot::hand_mark(arm, q + kSpan_s * speed) - robot::hand_mark(arm, q - kSpan_s * speed)) / (2.0 * kSpan_s);
}

}  // namespace

// d p_CM, and d p_CG alike, by the states of the arm's structure.
KinematicBias::Structure KinematicBias::by_structure(const robot::ArmDescription& arm, const robot::JointVector& q) {
  Structure h;
  h.middleCols<3>(kOffset).setIdentity();
  h.col(kUpperArm) = robot::grip_pose(arm, {q[0], q[1], 0.0}).linear().col(1);
  h.col(kForearm) = robot::grip_pose(arm, q).linear().col(1);
  return h;
}

// d p_CM by the states.
KinematicBias::Observation KinematicBias::observation(const robot::ArmDescription& arm, const JointMotion& joints) {
  Observation h;
  h.leftCols<kStructure>() = by_structure(arm, joints.q);
  h.col(kPlay) = -hand_velocity(arm, joints.q, joints.trailing);
  h.col(kLag) = -hand_velocity(arm, joints.q, joints.speed);
  h.col(kRunUp) = -hand_velocity(arm, joints.q, joints.speed.cwiseProduct(joints.speed.cwiseAbs()));
  return h;
}

void KinematicBias::begin(const KinematicBiasParameters& parameters) {
  begun_ = true;
  state_.setZero();
  covariance_.setZero();
  covariance_.diagonal() << Eigen::Vector3d::Constant(squared(parameters.offset_sigma)),
      Eigen::Vector2d::Constant(squared(parameters.link_sigma)), squared(parameters.play_sigma),
      squared(parameters.lag_sigma), squared(parameters.run_up_sigma);
}

void KinematicBias::observe(const robot::ArmDescription& arm, const KinematicBiasParameters& parameters,
                            const JointMotion& joints, const Eigen::Vector3d& p_CM) {
  if (!begun_) begin(parameters);
  covariance_.diagonal().segment<3>(kOffset).array() += squared(parameters.offset_drift);
  const Observation h = observation(arm, joints);
  const double variance = squared(parameters.sight_sigma) + squared(parameters.clock_sigma * h.col(kLag).norm());
  const auto expected = [&]() -> Eigen::Matrix3d {
    return h * covariance_ * h.transpose() + variance * Eigen::Matrix3d::Identity();
  };
  const Eigen::Vector3d seen = kinematic_bias(arm, joints.q, p_CM);
  const Eigen::Vector3d surprise = seen - h * state_;
  const bool contradicts = surprise.norm() > parameters.surprise &&
                           surprise.dot(expected().inverse() * surprise) > squared(parameters.surprise_sigmas);
  const bool twice = contradicts && contradicted_;
  contradicted_ = contradicts && !twice;
  if (contradicted_) return;
  if (twice) begin(parameters);
  const Eigen::Matrix<double, kStates, 3> gain = covariance_ * h.transpose() * expected().inverse();
  state_ += gain * (seen - h * state_);
  const Covariance updated = (Covariance::Identity() - gain * h) * covariance_;
  covariance_ = 0.5 * (updated + updated.transpose());
}

Eigen::Vector3d KinematicBias::at(const robot::ArmDescription& arm, const robot::JointVector& q,
                                  const robot::JointVector& trailing) const {
  // Where offset and links are off the grip point shifts as the mark does, but not where the shafts lag: they turn both
  // about the joints, and the grip point is farther out.
  return by_structure(arm, q) * state_.head<kStructure>() -
         robot::grip_point_jacobian(arm, q) * trailing * state_[kPlay];
}

robot::JointVector KinematicBias::shafts(const robot::JointVector& q, const robot::JointVector& trailing) const {
  return q - state_[kPlay] * trailing;
}

}  // namespace markservo::visual_servo
