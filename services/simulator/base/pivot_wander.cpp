#include "services/simulator/base/pivot_wander.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::simulator {
namespace {

// rad of turning: little of what happens between two rounds of a reader.
constexpr double kStretch = 0.02;

}  // namespace

Eigen::Vector2d PivotWander::turn(double turn) {
  Eigen::Vector2d moved = Eigen::Vector2d::Zero();
  double rest = std::abs(turn);
  if (per_sqrt_rad_ == 0.0) {
    turned_ += rest;
    return moved;
  }
  while (rest > 0.0) {
    if (turned_ >= until_) {
      const double sigma = per_sqrt_rad_ / std::sqrt(kStretch);
      push_.x() = sigma * bits_.gaussian();
      push_.y() = sigma * bits_.gaussian();
      until_ = turned_ + kStretch;
    }
    const double angle = std::min(rest, until_ - turned_);
    moved += angle * push_;
    turned_ += angle;
    rest -= angle;
  }
  return moved;
}

}  // namespace markservo::simulator
