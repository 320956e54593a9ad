#pragma once

// Where a mark is in both images.

#include "services/mark-detector/blobs/shape.hpp"

namespace markservo::mark_detector {

// Of the centroids, px; in a rectified pair the rows are the same.
struct PairPlace {
  double u_left = 0.0;
  double v_left = 0.0;
  double u_right = 0.0;
};

inline PairPlace place_of(const Shape& left, const Shape& right) {
  return {left.u, left.v, right.u};
}

// Squared distance, px^2.
inline double distance_2(const PairPlace& a, const PairPlace& b) {
  const double du_left = a.u_left - b.u_left;
  const double dv = a.v_left - b.v_left;
  const double du_right = a.u_right - b.u_right;
  return du_left * du_left + dv * dv + du_right * du_right;
}

}  // namespace markservo::mark_detector
