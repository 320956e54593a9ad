#include "services/visual-servo/kinematic_bias.hpp"

#include <Eigen/LU>

#include "common/robot/arm_kinematics.hpp"
#include "services/visual-servo/in_flight.hpp"

namespace markservo::visual_servo {
namespace {

using Observation = Eigen::Matrix<double, 3, 5>;

// d p_CG by offset and by the lengths of upper arm and forearm.
Observation observation(const robot::ArmDescription& arm, const robot::JointVector& q) {
  Observation h;
  h.leftCols<3>().setIdentity();
  h.col(3) = robot::grip_pose(arm, {q[0], q[1], 0.0}).linear().col(1);
  h.col(4) = robot::grip_pose(arm, q).linear().col(1);
  return h;
}

}  // namespace

void KinematicBias::see(const robot::ArmDescription& arm, const KinematicBiasParameters& parameters,
                        const robot::JointVector& q_exposure, const Eigen::Vector3d& p_CM, double grip_speed) {
  const auto squared = [](double sigma) { return sigma * sigma; };
  if (!begun_) {
    begun_ = true;
    covariance_.diagonal() << Eigen::Vector3d::Constant(squared(parameters.offset_sigma)),
        Eigen::Vector2d::Constant(squared(parameters.link_sigma));
  }
  covariance_.diagonal().head<3>().array() += squared(parameters.offset_drift);
  const Observation h = observation(arm, q_exposure);
  const double variance = squared(parameters.sight_sigma) + squared(parameters.clock_sigma * grip_speed);
  const Eigen::Matrix3d expected = h * covariance_ * h.transpose() + variance * Eigen::Matrix3d::Identity();
  const Eigen::Matrix<double, 5, 3> gain = covariance_ * h.transpose() * expected.inverse();
  state_ += gain * (kinematic_bias(arm, q_exposure, p_CM) - h * state_);
  const Matrix5 updated = (Matrix5::Identity() - gain * h) * covariance_;
  covariance_ = 0.5 * (updated + updated.transpose());
}

Eigen::Vector3d KinematicBias::at(const robot::ArmDescription& arm, const robot::JointVector& q) const {
  return observation(arm, q) * state_;
}

}  // namespace markservo::visual_servo
