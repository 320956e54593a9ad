#include "services/rfid-localizer/paper_method.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "common/geometry/plane_pose.hpp"
#include "common/time/seconds_between.hpp"

namespace markservo::rfid_localizer {

Eigen::Vector2d weighted_average(const std::vector<Eigen::Vector2d>& tags, double weight_sigma) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& tag : tags) mean += tag / static_cast<double>(tags.size());
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weights = 0.0;
  for (const Eigen::Vector2d& tag : tags) {
    const double weight = std::exp(-0.5 * (tag - mean).squaredNorm() / (weight_sigma * weight_sigma));
    sum += weight * tag;
    weights += weight;
  }
  return sum / weights;
}

std::optional<double> hough_direction(const std::deque<Eigen::Vector2d>& points, const PaperParameters& parameters) {
  if (static_cast<int>(points.size()) < std::max(parameters.least_recent, 2)) return std::nullopt;
  const Eigen::Vector2d chord = points.back() - points.front();
  if (chord.norm() < parameters.least_way) return std::nullopt;

  // A line is told by its normal's angle and its distance from the points' middle. A point votes for the bins next to
  // its distance with the share that falls to each, so that no bin's border decides.
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) middle += point / static_cast<double>(points.size());
  const int angles = static_cast<int>(std::lround(M_PI / parameters.angle_step));
  std::vector<double> best(static_cast<std::size_t>(angles), 0.0);
  for (int i = 0; i < angles; ++i) {
    const double angle = i * parameters.angle_step;
    const Eigen::Vector2d normal(-std::sin(angle), std::cos(angle));
    std::map<int, double> votes;
    for (const Eigen::Vector2d& point : points) {
      const double place = normal.dot(point - middle) / parameters.line_width;
      const int bin = static_cast<int>(std::floor(place));
      votes[bin] += 1.0 - (place - bin);
      votes[bin + 1] += place - bin;
    }
    for (const auto& [bin, count] : votes)
      best[static_cast<std::size_t>(i)] = std::max(best[static_cast<std::size_t>(i)], count);
  }
  // The peak is often a plateau: its middle, told on the doubled circle, where a line has one angle.
  const double top = *std::max_element(best.begin(), best.end());
  constexpr double kPlateau = 0.98;
  double sine = 0.0;
  double cosine = 0.0;
  for (int i = 0; i < angles; ++i) {
    if (best[static_cast<std::size_t>(i)] < kPlateau * top) continue;
    sine += std::sin(2.0 * i * parameters.angle_step);
    cosine += std::cos(2.0 * i * parameters.angle_step);
  }
  double direction = 0.5 * std::atan2(sine, cosine);
  if (chord.dot(Eigen::Vector2d(std::cos(direction), std::sin(direction))) < 0.0) direction += M_PI;
  return geometry::wrapped(direction);
}

double PaperMethod::own_speed() const {
  if (times_.size() < 2) return 0.0;
  const double time = seconds_between(times_.front(), times_.back());
  return time > 0.0 ? (averages_.back() - averages_.front()).norm() / time : 0.0;
}

std::optional<PaperEstimate> PaperMethod::observe(std::int64_t utime, const std::vector<Eigen::Vector2d>& tags,
                                                  const std::optional<double>& speed) {
  if (tags.empty()) return std::nullopt;
  PaperEstimate estimate;
  estimate.utime = utime;
  estimate.measured = weighted_average(tags, parameters_.weight_sigma);
  averages_.push_back(estimate.measured);
  times_.push_back(utime);
  if (static_cast<int>(averages_.size()) > parameters_.recent) {
    averages_.pop_front();
    times_.pop_front();
  }
  estimate.direction = hough_direction(averages_, parameters_);
  estimate.speed = speed.value_or(own_speed());
  estimate.delay = parameters_.delay;
  estimate.compensated = estimate.measured;
  if (estimate.direction) {
    const Eigen::Vector2d forward(std::cos(*estimate.direction), std::sin(*estimate.direction));
    estimate.compensated += estimate.speed * estimate.delay * forward;
  }
  newest_ = estimate;
  return estimate;
}

void PaperMethod::forget() {
  averages_.clear();
  times_.clear();
  newest_.reset();
}

}  // namespace markservo::rfid_localizer
