#pragma once

// Poses on the floor. Monogram notation: X_AB is the pose of frame B in frame A; X_AC = X_AB * X_BC.

#include <Eigen/Core>
#include <cmath>

namespace markservo::base_navigator {

// rad, the same direction within -pi to pi.
inline double wrapped(double angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

struct PlanePose {
  double x = 0.0;        // m
  double y = 0.0;        // m
  double heading = 0.0;  // rad, of the x axis, counter-clockwise

  Eigen::Vector2d position() const { return {x, y}; }
  double distance() const { return std::hypot(x, y); }

  // X_BA of an X_AB.
  PlanePose inverse() const {
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    return {-c * x - s * y, s * x - c * y, -heading};
  }
};

// p_A of a p_B.
inline Eigen::Vector2d operator*(const PlanePose& X_AB, const Eigen::Vector2d& p_B) {
  const double c = std::cos(X_AB.heading);
  const double s = std::sin(X_AB.heading);
  return {X_AB.x + c * p_B.x() - s * p_B.y(), X_AB.y + s * p_B.x() + c * p_B.y()};
}

inline PlanePose operator*(const PlanePose& X_AB, const PlanePose& X_BC) {
  const Eigen::Vector2d p_A = X_AB * X_BC.position();
  return {p_A.x(), p_A.y(), wrapped(X_AB.heading + X_BC.heading)};
}

}  // namespace markservo::base_navigator
