#pragma once

// A straight line through the points of an edge, some of which may be something else's.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace markservo::target_locator {

struct EdgePoint {
  float along = 0.0F;     // px, from the line's middle
  float across = 0.0F;    // px
  float residual = 0.0F;  // px, from the line that was fitted
  bool good = true;       // on it
};

// The points of an edge, in order along it.
using EdgePoints = std::vector<EdgePoint>;

// across = p + q along.
struct EdgeLine {
  double p = 0.0;  // px
  double q = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of (p, q); neighbours share texture and count for less
  double rms = 0.0;                                      // px, of the good points
  std::size_t good = 0;                                  // points on it
};

// Fits a line to the points within three robust sigmas of it, at least `tolerance` px. Nothing for fewer than 6.
std::optional<EdgeLine> fit_edge_line(EdgePoints& points, float tolerance);

}  // namespace markservo::target_locator
