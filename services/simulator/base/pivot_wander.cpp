#include "services/simulator/base/pivot_wander.hpp"

#include <cmath>

namespace markservo::simulator {
namespace {

// rad of turning: little of what happens between two rounds of a reader.
constexpr double kStretch = 0.02;

}  // namespace

Eigen::Vector2d PivotWander::turn(double turn) {
  const double angle = std::abs(turn);
  turned_ += angle;
  if (per_sqrt_rad_ == 0.0 || angle == 0.0) return Eigen::Vector2d::Zero();
  if (turned_ >= until_) {
    const double sigma = per_sqrt_rad_ / std::sqrt(kStretch);
    push_.x() = sigma * bits_.gaussian();
    push_.y() = sigma * bits_.gaussian();
    until_ = turned_ + kStretch;
  }
  return angle * push_;
}

}  // namespace markservo::simulator
