#pragma once

// Straight lines in a patch, and what four of them enclose. Coordinates are (column, row), patch px.

#include <Eigen/Core>
#include <array>
#include <optional>

namespace markservo::target_locator {

// n . x = c with n not normalised.
struct ImageLine {
  Eigen::Vector2d n;
  double c;
};

using Lines = std::array<ImageLine, 4>;
using Corners = std::array<Eigen::Vector2d, 4>;

// Nothing for lines that are all but parallel.
std::optional<Eigen::Vector2d> intersect(const ImageLine& a, const ImageLine& b);

// Corner k lies between lines k and k + 1.
std::optional<Corners> corners_of(const Lines& lines);

// Where the diagonals meet.
std::optional<Eigen::Vector2d> diagonals_meet(const Corners& corners);

}  // namespace markservo::target_locator
