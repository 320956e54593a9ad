#include "services/rfid-localizer/wheel_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::rfid_localizer {

namespace {

// An arc ends where its chord does; a piece of the record may bend much when readings were lost.
// A wheel that is larger than told turns the robot by more as well.
struct Arc {
  double turn, way, middle;  // rad; m, of the chord; rad, its direction

  Arc(const StateVector& state, const WheelMotion& motion)
      : turn(motion.turn * (1.0 + state[kScale])),
        way(geometry::chord(motion.way * (1.0 + state[kScale]), turn)),
        middle(state[kHeading] + 0.5 * turn) {}
};

}  // namespace

StateCovariance motion_jacobian(const StateVector& state, const WheelMotion& motion) {
  const Arc arc(state, motion);
  const double c = std::cos(arc.middle);
  const double s = std::sin(arc.middle);
  StateCovariance F = StateCovariance::Identity();
  F(kX, kHeading) = -arc.way * s;
  F(kY, kHeading) = arc.way * c;
  // A wheel that is larger makes the chord longer and turns it.
  const double longer = motion.way * std::cos(0.5 * arc.turn);
  F(kX, kScale) = longer * c - arc.way * s * 0.5 * motion.turn;
  F(kY, kScale) = longer * s + arc.way * c * 0.5 * motion.turn;
  F(kHeading, kScale) = motion.turn;
  return F;
}

NoiseShares noise_shares(const StateVector& state, const WheelMotion& motion, const WheelNoise& noise) {
  const Arc arc(state, motion);
  const Eigen::Vector2d along(std::cos(arc.middle), std::sin(arc.middle));
  const double turned = noise.turn_error * noise.turn_error * std::abs(motion.turn);
  // Wheels that run against each other go farther than the robot's middle. Those as good as most drift less on that
  // than track and tyres let the turning err.
  const double way = std::abs(motion.way);
  const double against = std::max(0.0, 0.5 * noise.track * std::abs(motion.turn) - way);
  const bool drifting = noise.drift * noise.drift * against > turned;
  const double travel = drifting ? way + against : way;
  NoiseShares shares;
  shares.turning = drifting ? 0.0 : turned;
  shares.drift(kHeading, kHeading) = travel;
  // Independent wheels that let the heading drift so much let the way vary by this.
  shares.drift.topLeftCorner<2, 2>() = 0.25 * noise.track * noise.track * travel * along * along.transpose();
  shares.pivot_wander.topLeftCorner<2, 2>() = motion.turning * Eigen::Matrix2d::Identity();
  return shares;
}

void advance(Hypothesis& hypothesis, const WheelMotion& motion, const WheelNoise& noise) {
  StateVector& x = hypothesis.mean;
  const Arc arc(x, motion);
  const double c = std::cos(arc.middle);
  const double s = std::sin(arc.middle);
  const StateCovariance F = motion_jacobian(x, motion);
  const NoiseShares shares = noise_shares(x, motion, noise);

  x[kX] += arc.way * c;
  x[kY] += arc.way * s;
  x[kHeading] += arc.turn;

  StateCovariance& P = hypothesis.covariance;
  P = F * P * F.transpose();
  P += noise.drift * noise.drift * shares.drift + noise.pivot_wander * noise.pivot_wander * shares.pivot_wander;
  P(kHeading, kHeading) += shares.turning;
  const double creep_variance = noise.creep * noise.creep * motion.time + motion.unknown_way * motion.unknown_way;
  P(kX, kX) += creep_variance;
  P(kY, kY) += creep_variance;
  P(kScale, kScale) += noise.scale_walk * noise.scale_walk * std::abs(motion.way);
  P(kDelay, kDelay) += noise.delay_walk * noise.delay_walk * motion.time;
  // Where the robot went unseen it may have turned as well.
  if (motion.unknown_way > 0.0)
    P(kHeading, kHeading) += motion.unknown_way * motion.unknown_way / (noise.track * noise.track);
}

}  // namespace markservo::rfid_localizer
