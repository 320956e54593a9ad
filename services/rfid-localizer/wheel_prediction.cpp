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

// What the wheels' noise grows with.
struct NoisyWay {
  double travel;   // m, on which the wheels drift
  double turning;  // rad^2, of the heading, from the turning itself

  NoisyWay(const WheelMotion& motion, const WheelNoise& noise) {
    const double turned = noise.turn_error * noise.turn_error * std::abs(motion.turn);
    // Wheels that run against each other go farther than the robot's middle. Those as good as most drift less on that
    // than track and tyres let the turning err.
    const double way = std::abs(motion.way);
    const double against = std::max(0.0, 0.5 * noise.track * std::abs(motion.turn) - way);
    const bool drifting = noise.drift * noise.drift * against > turned;
    travel = drifting ? way + against : way;
    turning = drifting ? 0.0 : turned;
  }
};

}  // namespace

StateCovariance motion_jacobian(const StateVector& state, const WheelMotion& motion) {
  const Arc arc(state, motion);
  const double c = std::cos(arc.middle);
  const double s = std::sin(arc.middle);
  StateCovariance F = StateCovariance::Identity();
  F(kX, kHeading) = -arc.way * s;
  F(kY, kHeading) = arc.way * c;
  // Of the chord's length and of its direction.
  const double longer = motion.way * std::cos(0.5 * arc.turn);
  F(kX, kScale) = longer * c - arc.way * s * 0.5 * motion.turn;
  F(kY, kScale) = longer * s + arc.way * c * 0.5 * motion.turn;
  F(kHeading, kScale) = motion.turn;
  return F;
}

NoiseShares noise_shares(const StateVector& state, const WheelMotion& motion, const WheelNoise& noise) {
  const Arc arc(state, motion);
  const Eigen::Vector2d along(std::cos(arc.middle), std::sin(arc.middle));
  const double travel = NoisyWay(motion, noise).travel;
  NoiseShares shares;
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

  x[kX] += arc.way * c;
  x[kY] += arc.way * s;
  x[kHeading] += arc.turn;

  StateCovariance& P = hypothesis.covariance;
  P = F * P * F.transpose();
  const NoisyWay noisy(motion, noise);
  const double heading_variance = noise.drift * noise.drift * noisy.travel + noisy.turning;
  // Independent wheels that let the heading drift so much let the way vary by this.
  const double way_variance = 0.25 * noise.track * noise.track * noise.drift * noise.drift * noisy.travel;
  const double creep_variance = noise.creep * noise.creep * motion.time + motion.unknown_way * motion.unknown_way;
  const double wander_variance = noise.pivot_wander * noise.pivot_wander * motion.turning;
  P(kHeading, kHeading) += heading_variance;
  P(kX, kX) += way_variance * c * c + (creep_variance + wander_variance);
  P(kX, kY) += way_variance * c * s;
  P(kY, kX) += way_variance * c * s;
  P(kY, kY) += way_variance * s * s + (creep_variance + wander_variance);
  P(kScale, kScale) += noise.scale_walk * noise.scale_walk * std::abs(motion.way);
  P(kDelay, kDelay) += noise.delay_walk * noise.delay_walk * motion.time;
  // Where the robot went unseen it may have turned as well.
  if (motion.unknown_way > 0.0)
    P(kHeading, kHeading) += motion.unknown_way * motion.unknown_way / (noise.track * noise.track);
}

}  // namespace markservo::rfid_localizer
