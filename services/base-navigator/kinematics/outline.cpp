#include "services/base-navigator/kinematics/outline.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::base_navigator {

double Outline::reach() const {
  return std::hypot(std::max(front, rear), half_width);
}

double distance_to_outline(const Outline& outline, const Eigen::Vector2d& p_R) {
  const double beyond_x = std::max({p_R.x() - outline.front, -outline.rear - p_R.x(), 0.0});
  const double beyond_y = std::max(std::abs(p_R.y()) - outline.half_width, 0.0);
  return std::hypot(beyond_x, beyond_y);
}

}  // namespace markservo::base_navigator
