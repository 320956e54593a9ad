#pragma once

// How the two cameras of a pair stand to each other, by points that both show.

#include <optional>

#include "services/camera-check/pair/corner_matches.hpp"

namespace markservo::camera_check {

// How much lower the right picture shows a point than the left one, px; medians. In a rectified pair all are 0.
struct RowOffsets {
  double middle_px = 0.0;          // of all points
  std::optional<double> left_px;   // of the leftmost third of them; nothing where these are too few
  std::optional<double> right_px;  // of the rightmost third
  // The largest of them, by its amount.
  double worst_px() const;
};

struct PairGeometry {
  int num_corners = 0;
  int num_matches = 0;
  double behind_share = 0.0;    // of the matches whose disparity is negative: behind infinity, 0 to 1
  bool is_one_picture = false;  // both sides show the same from the same place
  RowOffsets rows;
};

// `infinity_px`: the disparity of what is infinitely far, cx_left - cx_right.
PairGeometry geometry_of(const PairMatches& found, double infinity_px);

}  // namespace markservo::camera_check
