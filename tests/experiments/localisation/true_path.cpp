#include "tests/experiments/localisation/true_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "common/geometry/plane_pose.hpp"

namespace markservo::experiments {

Eigen::Vector2d PathPoint::at(const Eigen::Vector2d& p_R) const {
  return p_WR + Eigen::Rotation2Dd(heading) * p_R;
}

TruePath::TruePath(std::vector<PathPoint> points) : points_(std::move(points)) {
  if (points_.size() < 2) throw std::invalid_argument("TruePath: fewer than two points");
  for (std::size_t i = 1; i < points_.size(); ++i) {
    if (!(points_[i].time > points_[i - 1].time)) throw std::invalid_argument("TruePath: times that do not rise");
    points_[i].heading = points_[i - 1].heading + geometry::wrapped(points_[i].heading - points_[i - 1].heading);
  }
}

PathPoint TruePath::at(double time) const {
  const auto straight_on = [time](PathPoint point) {
    const double along = point.speed * (time - point.time);
    point.p_WR += along * Eigen::Vector2d(std::cos(point.heading), std::sin(point.heading));
    point.time = time;
    return point;
  };
  if (time <= points_.front().time) return straight_on(points_.front());
  if (time >= points_.back().time) return straight_on(points_.back());
  const auto after = std::upper_bound(points_.begin(), points_.end(), time,
                                      [](double t, const PathPoint& point) { return t < point.time; });
  const PathPoint& a = *std::prev(after);
  const PathPoint& b = *after;
  const double share = (time - a.time) / (b.time - a.time);
  PathPoint point;
  point.time = time;
  point.p_WR = a.p_WR + share * (b.p_WR - a.p_WR);
  point.heading = a.heading + share * (b.heading - a.heading);
  point.speed = a.speed + share * (b.speed - a.speed);
  point.turn_rate = a.turn_rate + share * (b.turn_rate - a.turn_rate);
  point.wheel_travel = a.wheel_travel + share * (b.wheel_travel - a.wheel_travel);
  point.turned = a.turned + share * (b.turned - a.turned);
  return point;
}

}  // namespace markservo::experiments
