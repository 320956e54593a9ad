#include "services/rfid-localizer/free_motion.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "common/time/seconds_between.hpp"

namespace markservo::rfid_localizer {
namespace {

constexpr int kStanding = 0;
constexpr int kCruising = 1;
constexpr int kManoeuvring = 2;
constexpr int kModes = 3;

// A standing robot's velocity, m/s: so little that its place stays.
constexpr double kStill = 1e-3;

void stand(Hypothesis& one) {
  one.mean.segment<2>(kVelocityX).setZero();
  for (const int i : {kVelocityX, kVelocityY}) {
    one.covariance.row(i).setZero();
    one.covariance.col(i).setZero();
    one.covariance(i, i) = kStill * kStill;
  }
}

// Probabilities to be in mode [to] after having been in mode [from] `time` (s) before.
Eigen::Matrix3d transitions(const FreeMotionParameters& parameters, double time) {
  const double off = 1.0 - std::exp(-parameters.setting_off * time);
  const double settled = 0.5 * (1.0 - std::exp(-2.0 * parameters.settling * time));
  Eigen::Matrix3d to_from = Eigen::Matrix3d::Zero();
  to_from(kStanding, kStanding) = to_from(kCruising, kCruising) = 1.0 - off;
  to_from(kManoeuvring, kStanding) = to_from(kManoeuvring, kCruising) = off;
  to_from(kStanding, kManoeuvring) = to_from(kCruising, kManoeuvring) = settled;
  to_from(kManoeuvring, kManoeuvring) = 1.0 - 2.0 * settled;
  return to_from;
}

// What each mode believes after any may have become it.
Mixture switched(const Mixture& mixture, const Eigen::Matrix3d& to_from) {
  Mixture result;
  for (int to = 0; to < kModes; ++to) {
    Mixture parts = mixture;
    for (Hypothesis& part : parts) part.weight *= to_from(to, part.mode);
    Hypothesis one = moments(parts, -1);
    one.mode = to;
    if (to == kStanding) stand(one);
    result.push_back(one);
  }
  return result;
}

}  // namespace

FreeMotionModel::FreeMotionModel(const Eigen::Vector2d& p_RF, const FreeMotionParameters& parameters)
    : p_RF_(p_RF), parameters_(parameters) {}

Mixture FreeMotionModel::start(const Place& place, const DelayPrior& delay) const {
  Hypothesis one;
  one.weight = 1.0 / kModes;
  one.mean.head<2>() = place.mean;
  one.mean[kDelay] = delay.mean;
  one.covariance.topLeftCorner<2, 2>() = place.covariance;
  const double speed_variance = parameters_.speed_sigma * parameters_.speed_sigma;
  one.covariance(kVelocityX, kVelocityX) = one.covariance(kVelocityY, kVelocityY) = speed_variance;
  one.covariance(kDelay, kDelay) = delay.sigma * delay.sigma;
  Mixture mixture(kModes, one);
  for (int mode = 0; mode < kModes; ++mode) mixture[static_cast<std::size_t>(mode)].mode = mode;
  stand(mixture[kStanding]);
  return mixture;
}

void FreeMotionModel::predict(Mixture& mixture, std::int64_t from, std::int64_t to) const {
  if (to <= from) return;
  const double t = seconds_between(from, to);
  mixture = switched(mixture, transitions(parameters_, t));
  StateCovariance F = StateCovariance::Identity();
  F(kX, kVelocityX) = F(kY, kVelocityY) = t;
  const std::array<double, kModes> strengths = {0.0, parameters_.cruise, parameters_.manoeuvre};
  for (Hypothesis& one : mixture) {
    one.mean = F * one.mean;
    one.covariance = F * one.covariance * F.transpose();
    const double strength = strengths[static_cast<std::size_t>(one.mode)];
    const double q = strength * strength;
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
  // A way to move that has not been lately must be able to come back.
  constexpr double kLeast = 1e-3;
  double sum = 0.0;
  for (const Hypothesis& one : mixture) sum += one.weight;
  Mixture by_mode;
  for (int mode = 0; mode < kModes; ++mode) {
    Mixture parts;
    for (const Hypothesis& one : mixture) {
      if (one.mode == mode) parts.push_back(one);
    }
    by_mode.push_back(moments(parts, -1));
    by_mode.back().weight = std::max(by_mode.back().weight / sum, kLeast);
  }
  mixture = std::move(by_mode);
}

PoseEstimate FreeMotionModel::pose(const Mixture& mixture, std::int64_t /*utime*/) const {
  const Hypothesis all = moments(mixture, -1);
  const Eigen::Vector2d velocity = all.mean.segment<2>(kVelocityX);
  const double speed_squared = velocity.squaredNorm();
  const double heading = std::atan2(velocity.y(), velocity.x());
  const Eigen::Vector2d offset = Eigen::Rotation2Dd(heading) * p_RF_;

  // The heading by the velocity: its variance at speed, that of any heading at rest.
  constexpr double kAtRest = 1e-12;  // m^2/s^2
  StateVector by_velocity = StateVector::Zero();
  if (speed_squared > kAtRest) {
    by_velocity[kVelocityX] = -velocity.y() / speed_squared;
    by_velocity[kVelocityY] = velocity.x() / speed_squared;
    const double variance = by_velocity.dot(all.covariance * by_velocity);
    if (variance > kAnyHeading) by_velocity *= std::sqrt(kAnyHeading / variance);
  }
  // R lies `offset` behind the antenna, where the heading turns it to.
  const Eigen::Vector3d turned(offset.y(), -offset.x(), 1.0);
  Eigen::Matrix<double, 3, 5> J = turned * by_velocity.transpose();
  J(0, kX) = J(1, kY) = 1.0;
  PoseEstimate estimate;
  estimate.covariance = J * all.covariance * J.transpose();
  if (speed_squared <= kAtRest) estimate.covariance += kAnyHeading * turned * turned.transpose();
  estimate.pose << all.mean.head<2>() - offset, heading;
  estimate.speed = std::sqrt(speed_squared);
  return estimate;
}

}  // namespace markservo::rfid_localizer
