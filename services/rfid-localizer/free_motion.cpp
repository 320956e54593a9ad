#include "services/rfid-localizer/free_motion.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace markservo::rfid_localizer {
namespace {

// What the two modes believe after either may have become the other within `time` (s).
void switch_modes(Mixture& mixture, double rate, double time) {
  const double stay = 0.5 * (1.0 + std::exp(-2.0 * rate * time));
  Mixture mixed(2);
  for (std::size_t to = 0; to < 2; ++to) {
    Mixture parts = mixture;
    for (std::size_t from = 0; from < 2; ++from) parts[from].weight *= from == to ? stay : 1.0 - stay;
    mixed[to] = moments(parts, -1);
  }
  mixture = std::move(mixed);
}

}  // namespace

FreeMotionModel::FreeMotionModel(const Eigen::Vector2d& p_RF, const FreeMotionParameters& parameters)
    : p_RF_(p_RF), parameters_(parameters) {}

Mixture FreeMotionModel::start(const Place& place, const DelayPrior& delay) const {
  Hypothesis one;
  one.weight = 0.5;
  one.mean.head<2>() = place.mean;
  one.mean[kDelay] = delay.mean;
  one.covariance.topLeftCorner<2, 2>() = place.covariance;
  const double speed_variance = parameters_.speed_sigma * parameters_.speed_sigma;
  one.covariance(kVelocityX, kVelocityX) = one.covariance(kVelocityY, kVelocityY) = speed_variance;
  one.covariance(kDelay, kDelay) = delay.sigma * delay.sigma;
  return {one, one};
}

void FreeMotionModel::predict(Mixture& mixture, std::int64_t from, std::int64_t to) const {
  if (to <= from) return;
  const double t = 1e-6 * static_cast<double>(to - from);
  switch_modes(mixture, parameters_.switch_rate, t);
  StateCovariance F = StateCovariance::Identity();
  F(kX, kVelocityX) = F(kY, kVelocityY) = t;
  const std::array<double, 2> strengths = {parameters_.cruise, parameters_.manoeuvre};
  for (std::size_t mode = 0; mode < 2; ++mode) {
    Hypothesis& one = mixture[mode];
    one.mean = F * one.mean;
    one.covariance = F * one.covariance * F.transpose();
    const double q = strengths[mode] * strengths[mode];
    for (const int axis : {0, 1}) {
      one.covariance(axis, axis) += q * t * t * t / 3.0;
      one.covariance(axis, axis + 2) += q * t * t / 2.0;
      one.covariance(axis + 2, axis) += q * t * t / 2.0;
      one.covariance(axis + 2, axis + 2) += q * t;
    }
    one.covariance(kDelay, kDelay) += parameters_.delay_walk * parameters_.delay_walk * t;
  }
}

AntennaView FreeMotionModel::antenna(const Hypothesis& hypothesis, std::int64_t /*middle*/,
                                     std::int64_t /*round*/) const {
  AntennaView view;
  view.p_WF = hypothesis.mean.head<2>();
  view.H.leftCols<2>().setIdentity();
  view.velocity = hypothesis.mean.segment<2>(kVelocityX);
  return view;
}

void FreeMotionModel::clean(Mixture& mixture) const {
  // A mode that has never been lately must be able to come back.
  constexpr double kLeast = 1e-3;
  double sum = 0.0;
  for (const Hypothesis& one : mixture) sum += one.weight;
  for (Hypothesis& one : mixture) one.weight = std::max(one.weight / sum, kLeast);
}

PoseEstimate FreeMotionModel::pose(const Mixture& mixture, std::int64_t /*utime*/) const {
  const Hypothesis all = moments(mixture, -1);
  const Eigen::Vector2d velocity = all.mean.segment<2>(kVelocityX);
  const double speed_squared = std::max(velocity.squaredNorm(), 1e-12);
  const double heading = std::atan2(velocity.y(), velocity.x());

  // The heading by the velocity: its variance at speed, that of any heading at rest.
  Eigen::Matrix<double, 3, 5> J = Eigen::Matrix<double, 3, 5>::Zero();
  J(0, kX) = J(1, kY) = 1.0;
  J(2, kVelocityX) = -velocity.y() / speed_squared;
  J(2, kVelocityY) = velocity.x() / speed_squared;
  PoseEstimate estimate;
  estimate.covariance = J * all.covariance * J.transpose();
  constexpr double kAnyHeading = M_PI * M_PI / 3.0;
  if (estimate.covariance(2, 2) > kAnyHeading) {
    const double shrink = std::sqrt(kAnyHeading / estimate.covariance(2, 2));
    estimate.covariance.row(2) *= shrink;
    estimate.covariance.col(2) *= shrink;
  }
  estimate.pose << all.mean.head<2>() - Eigen::Rotation2Dd(heading) * p_RF_, heading;
  estimate.speed = std::sqrt(speed_squared);
  return estimate;
}

}  // namespace markservo::rfid_localizer
