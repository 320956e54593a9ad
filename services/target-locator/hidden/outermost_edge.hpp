#pragma once

// How far an outline reaches in one direction, and whether it ends there in a straight edge.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "services/target-locator/hidden/plane_outlines.hpp"

namespace markservo::target_locator {

inline constexpr std::size_t kStrays = 2;  // outermost points that may be noise

struct OutermostEdge {
  double out = 0.0;     // m outwards, of the edge
  double length = 0.0;  // m, of its straight part
  double slope = 0.0;   // against the normal of the direction
  double slope_sigma = 1.0;
  double rms = 0.0;  // m, about its line
};

// The outermost edge of more than kStrays points. `outwards`: unit length; `pixel`: m, a patch pixel on the plane.
OutermostEdge outermost_edge(const Points& points, const Eigen::Vector2d& outwards, double pixel);

// The n-th smallest, from 0 on; n below the number of values.
double nth_value(std::vector<double> values, std::size_t n);

}  // namespace markservo::target_locator
