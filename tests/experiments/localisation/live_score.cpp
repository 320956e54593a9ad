#include "tests/experiments/localisation/live_score.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "common/geometry/plane_pose.hpp"

namespace markservo::experiments {
namespace {

constexpr double kSameTime = 1e-7;  // s: times are whole microseconds

double nees(const Eigen::Vector3d& error, const Eigen::Matrix3d& covariance) {
  return error.dot(covariance.inverse() * error);
}

}  // namespace

const PoseEstimate* newest(const std::vector<PoseEstimate>& estimates, double time) {
  const auto after = std::upper_bound(estimates.begin(), estimates.end(), time + kSameTime,
                                      [](double t, const PoseEstimate& estimate) { return t < estimate.time; });
  return after == estimates.begin() ? nullptr : &*std::prev(after);
}

PoseEstimate moved_on(PoseEstimate estimate, double time) {
  const double dt = time - estimate.time;
  const double turn = estimate.turn_rate * dt;
  const double middle = estimate.heading + 0.5 * turn;
  estimate.p_WR += estimate.speed * dt * Eigen::Vector2d(std::cos(middle), std::sin(middle));
  estimate.heading += turn;
  estimate.time = time;
  return estimate;
}

LiveScore score_live(const std::vector<PoseEstimate>& estimates, const TruePath& path, const std::vector<double>& times,
                     double settled_from, const LiveScoreParameters& parameters) {
  const auto earlier = [](const PoseEstimate& a, const PoseEstimate& b) { return a.time < b.time; };
  if (!std::is_sorted(estimates.begin(), estimates.end(), earlier)) {
    throw std::invalid_argument("score_live: estimates out of order");
  }
  LiveScore score;
  int far_off = 0;  // samples in a row
  for (const double time : times) {
    const PoseEstimate* last = newest(estimates, time);
    if (last == nullptr) {
      ++score.without_pose;
      continue;
    }
    const PoseEstimate estimate = moved_on(*last, time);
    const PathPoint truth = path.at(time);
    Eigen::Vector3d error;
    error << estimate.p_WR - truth.p_WR, geometry::wrapped(estimate.heading - truth.heading);
    const double radial = error.head<2>().norm();
    score.all.push_back(radial);
    if (time < settled_from - kSameTime) continue;
    score.settled.push_back(radial);
    if (std::abs(truth.speed) >= parameters.driving_speed) score.settled_heading.push_back(std::abs(error[2]));
    if (estimate.localised) {
      score.settled_nees.push_back(nees(error, estimate.covariance));
    } else {
      ++score.settled_not_localised;
    }
    // NaN is far off too.
    far_off = radial <= parameters.diverged_error ? 0 : far_off + 1;
    if (far_off >= parameters.diverged_samples) score.diverged = true;
  }
  return score;
}

}  // namespace markservo::experiments
