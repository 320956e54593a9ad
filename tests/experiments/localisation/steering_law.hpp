#pragma once

// How the simulated base is led along a course.

#include <algorithm>

namespace markservo::experiments {

inline constexpr double kAcceleration = 0.6;  // m/s^2, of the wanted speed; the base can do a little more

// rad/s, for a base at `speed` (m/s) that is `left` (m) to the left of a course of that `curvature` (1/m, positive to
// the left) and turned away from it by `heading_error` (rad). Only stability and small errors matter: the lateral error
// decays with 2.5 rad/s, critically damped, and at less than 0.15 m/s more slowly, lest the steering become violent.
inline double turn_rate_along(double speed, double curvature, double left, double heading_error) {
  constexpr double kNatural = 2.5;      // rad/s
  constexpr double kLeastSpeed = 0.15;  // m/s
  return speed * curvature - kNatural * kNatural / std::max(speed, kLeastSpeed) * left - 2.0 * kNatural * heading_error;
}

}  // namespace markservo::experiments
