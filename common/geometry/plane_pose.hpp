#pragma once

// Poses on the floor. Monogram notation: X_AB is the pose of frame B in frame A; X_AC = X_AB * X_BC.

#include <Eigen/Core>
#include <cmath>

#include "common/geometry/degrees.hpp"

namespace markservo::geometry {

// rad, the same direction within -pi to pi.
inline double wrapped(double angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

struct PlanePose {
  double x = 0.0;        // m
  double y = 0.0;        // m
  double heading = 0.0;  // rad, of the x axis, counter-clockwise from above

  Eigen::Vector2d position() const { return {x, y}; }
  double distance() const { return std::hypot(x, y); }

  // X_BA of an X_AB.
  PlanePose inverse() const {
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    return {-c * x - s * y, s * x - c * y, -heading};
  }
};

// The same from a heading in degrees, as files and options have it.
inline PlanePose pose_from_degrees(double x, double y, double heading_deg) {
  return {x, y, radians(heading_deg)};
}

// p_A of a p_B.
inline Eigen::Vector2d operator*(const PlanePose& X_AB, const Eigen::Vector2d& p_B) {
  const double c = std::cos(X_AB.heading);
  const double s = std::sin(X_AB.heading);
  return {X_AB.x + c * p_B.x() - s * p_B.y(), X_AB.y + s * p_B.x() + c * p_B.y()};
}

// The heading of the result is wrapped.
inline PlanePose operator*(const PlanePose& X_AB, const PlanePose& X_BC) {
  const Eigen::Vector2d p_A = X_AB * X_BC.position();
  return {p_A.x(), p_A.y(), wrapped(X_AB.heading + X_BC.heading)};
}

// m, straight from begin to end of an arc of length `way` (m) that turns by `turn` (rad); it points half the turn
// aside.
inline double chord(double way, double turn) {
  const double half = 0.5 * turn;
  return std::abs(half) < 1e-9 ? way : way * std::sin(half) / half;
}

}  // namespace markservo::geometry
