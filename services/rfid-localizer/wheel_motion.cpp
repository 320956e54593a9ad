#include "services/rfid-localizer/wheel_motion.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::rfid_localizer {
namespace {

constexpr std::int64_t kRateWindow_us = 60'000;  // three encoder readings: of one alone the ticks are too coarse

}  // namespace

WheelMotionModel::WheelMotionModel(const WheelHistory& history, const Eigen::Vector2d& p_RF,
                                   const WheelMotionParameters& parameters)
    : history_(history), p_RF_(p_RF), parameters_(parameters) {}

Mixture WheelMotionModel::start(const Place& place, const DelayPrior& delay) const {
  const int headings = heading_ ? 1 : parameters_.headings;
  const double spacing = 2.0 * M_PI / headings;
  // Evenly spaced Gaussians this wide add up to a flat prior within 1%.
  constexpr double kOverlap = 0.6;
  Mixture mixture;
  for (int i = 0; i < headings; ++i) {
    Hypothesis one;
    one.weight = 1.0 / headings;
    one.mean[kHeading] = heading_ ? heading_->mean : geometry::wrapped(i * spacing);
    const double sigma = heading_ ? heading_->sigma : kOverlap * spacing;
    const Eigen::Vector2d offset = Eigen::Rotation2Dd(one.mean[kHeading]) * p_RF_;
    one.mean.head<2>() = place.mean - offset;
    one.mean[kDelay] = delay.mean;
    one.covariance.topLeftCorner<2, 2>() =
        place.covariance + sigma * sigma * p_RF_.squaredNorm() * Eigen::Matrix2d::Identity();
    one.covariance(kHeading, kHeading) = sigma * sigma;
    one.covariance(kScale, kScale) = parameters_.scale_sigma * parameters_.scale_sigma;
    one.covariance(kDelay, kDelay) = delay.sigma * delay.sigma;
    mixture.push_back(one);
  }
  return mixture;
}

void WheelMotionModel::predict(Mixture& mixture, std::int64_t from, std::int64_t to) const {
  history_.replay(from, to, [&](const WheelMotion& piece) {
    for (Hypothesis& one : mixture) advance(one, piece, parameters_.noise);
  });
}

AntennaView WheelMotionModel::antenna(const Hypothesis& hypothesis, std::int64_t middle, std::int64_t round) const {
  const std::int64_t half = std::max(round, kRateWindow_us) / 2;
  const WheelMotion rate = history_.rate(middle - half, middle + half);
  const double heading = hypothesis.mean[kHeading];
  const Eigen::Vector2d forward(std::cos(heading), std::sin(heading));
  const Eigen::Vector2d offset = Eigen::Rotation2Dd(heading) * p_RF_;
  const Eigen::Vector2d across(-offset.y(), offset.x());
  AntennaView view;
  view.p_WF = hypothesis.mean.head<2>() + offset;
  view.H.leftCols<2>().setIdentity();
  view.H.col(kHeading) = across;
  view.velocity = rate.way * (1.0 + hypothesis.mean[kScale]) * forward + rate.turn * across;
  return view;
}

void WheelMotionModel::clean(Mixture& mixture) const {
  tidy(mixture, parameters_.least_weight, parameters_.merge_distance, parameters_.most, kHeading);
}

PoseEstimate WheelMotionModel::pose(const Mixture& mixture, std::int64_t utime) const {
  const Hypothesis all = moments(mixture, kHeading);
  const WheelMotion rate = history_.rate(utime - kRateWindow_us, utime);
  PoseEstimate estimate;
  estimate.pose = all.mean.head<3>();
  estimate.covariance = all.covariance.topLeftCorner<3, 3>();
  estimate.speed = rate.way * (1.0 + all.mean[kScale]);
  estimate.turn_rate = rate.turn;
  return estimate;
}

}  // namespace markservo::rfid_localizer
