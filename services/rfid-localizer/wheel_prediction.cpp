#include "services/rfid-localizer/wheel_prediction.hpp"

#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::rfid_localizer {

void advance(Hypothesis& hypothesis, const WheelMotion& motion, const WheelNoise& noise) {
  StateVector& x = hypothesis.mean;
  // An arc ends where its chord does; a piece of the record may bend much when readings were lost.
  // A wheel that is larger than told turns the robot by more as well.
  const double turn = motion.turn * (1.0 + x[kScale]);
  const double half = 0.5 * turn;
  const double way = geometry::chord(motion.way * (1.0 + x[kScale]), turn);
  const double middle = x[kHeading] + half;
  const double c = std::cos(middle);
  const double s = std::sin(middle);

  StateCovariance F = StateCovariance::Identity();
  F(kX, kHeading) = -way * s;
  F(kY, kHeading) = way * c;
  // Of the chord's length and of its direction.
  const double longer = motion.way * std::cos(half);
  F(kX, kScale) = longer * c - way * s * 0.5 * motion.turn;
  F(kY, kScale) = longer * s + way * c * 0.5 * motion.turn;
  F(kHeading, kScale) = motion.turn;

  x[kX] += way * c;
  x[kY] += way * s;
  x[kHeading] += turn;

  StateCovariance& P = hypothesis.covariance;
  P = F * P * F.transpose();
  const double length = std::abs(motion.way);
  const double heading_variance =
      noise.drift * noise.drift * length + noise.turn_error * noise.turn_error * std::abs(motion.turn);
  // Independent wheels that let the heading drift so much let the way vary by this.
  const double way_variance = 0.25 * noise.track * noise.track * noise.drift * noise.drift * length;
  const double creep_variance = noise.creep * noise.creep * motion.time + motion.unknown_way * motion.unknown_way;
  P(kHeading, kHeading) += heading_variance;
  P(kX, kX) += way_variance * c * c + creep_variance;
  P(kX, kY) += way_variance * c * s;
  P(kY, kX) += way_variance * c * s;
  P(kY, kY) += way_variance * s * s + creep_variance;
  P(kScale, kScale) += noise.scale_walk * noise.scale_walk * length;
  P(kDelay, kDelay) += noise.delay_walk * noise.delay_walk * motion.time;
  // Where the robot went unseen it may have turned as well.
  if (motion.unknown_way > 0.0)
    P(kHeading, kHeading) += motion.unknown_way * motion.unknown_way / (noise.track * noise.track);
}

}  // namespace markservo::rfid_localizer
