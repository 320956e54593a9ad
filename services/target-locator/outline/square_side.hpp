#pragma once

// One side of a square mark in one image.

#include <Eigen/Core>

#include "services/target-locator/image/plane_image.hpp"
#include "services/target-locator/outline/edge_line.hpp"
#include "services/target-locator/outline/image_line.hpp"

namespace markservo::target_locator {

struct SideParameters {
  double corner_share = 0.12;   // of each side's length left out at either end
  double min_span = 0.35;       // step of the contrast across the outline, 1 being the average
  double min_good_share = 0.6;  // of a side's points on its line
  double max_rms_px = 0.6;      // patch px, of a side's points about its line
};

// A side as across = p + q * (along - middle), patch px: `along` is the row of an upright side, the column of a lying
// one.
struct SquareSide {
  bool upright = true;
  bool inside_after = true;  // the mark lies at larger `across`
  double middle = 0.0;
  double p = 0.0;
  double q = 0.0;
  double from = 0.0;  // along, between the corners
  double to = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of (p, q)
  double rms = 0.0;

  double across(double along) const { return p + q * (along - middle); }
};

// The side on a line whose normal points outwards, between corners `a` and `b`.
SquareSide side_of(const ImageLine& line, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double corner_share);

// The side's line, or one with another p and q.
ImageLine line_of(const SquareSide& side, double p, double q);
inline ImageLine line_of(const SquareSide& side) {
  return line_of(side, side.p, side.q);
}

// Turns the side to where the mask begins near it, to half a pixel. `lines`: the mask for an upright side, its
// transpose for a lying one. False when the mask shows no such side. `points` is room.
bool fit_to_mask(const Mask& lines, const SideParameters& parameters, EdgePoints& points, SquareSide& side);

// Turns the side to the contrast's step near it, row by row, by the step's area within two and a half pixels of the
// line. False when too little of the side is seen. `points` is room.
bool fit_to_contrast(const PlaneImage& contrast, const SideParameters& parameters, EdgePoints& points,
                     SquareSide& side);

}  // namespace markservo::target_locator
