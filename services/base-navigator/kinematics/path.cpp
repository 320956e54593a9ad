#include "services/base-navigator/kinematics/path.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::base_navigator {

using geometry::PlanePose;

std::vector<PathPose> straight_path(Direction direction, double step, double length) {
  std::vector<PathPose> path = {{PlanePose(), 0.0}};
  const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
  for (int i = 1; i <= steps; ++i) {
    const double gone = length * i / steps;
    path.push_back({{sign_of(direction) * gone, 0.0, 0.0}, gone});
  }
  return path;
}

std::vector<PathPose> turning_path(const Outline& outline, double angle, double step) {
  std::vector<PathPose> path = {{PlanePose(), 0.0}};
  const double length = std::abs(angle) * outline.reach();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
  for (int i = 1; i <= steps; ++i) path.push_back({{0.0, 0.0, angle * i / steps}, length * i / steps});
  return path;
}

}  // namespace markservo::base_navigator
