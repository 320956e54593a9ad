#pragma once

#include <Eigen/Core>

namespace markservo::base_navigator {

// The robot from above, in R: -rear <= x <= front, |y| <= half_width; m.
struct Outline {
  double front = 0.0;
  double rear = 0.0;
  double half_width = 0.0;

  // m, from R's origin to the farthest corner: what a turn on the spot sweeps.
  double reach() const;
};

// m; 0 inside.
double distance_to_outline(const Outline& outline, const Eigen::Vector2d& p_R);

}  // namespace markservo::base_navigator
