#pragma once

// A contour to the accuracy that its pixels' noise allows.
//
// Around the outline of a mark of one colour the image is
//   outside + (inside - outside) share(distance from the outline, blur),
// and all of it is fitted to the pixels at once by least squares: the shape, the blur, and the two levels, which
// may change around the outline where the pixels say so. What the pixels leave unexplained is the noise.

#include <Eigen/Core>
#include <optional>

#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

struct ContourFitParameters {
  double reach_in = 7.0;          // patch px from the outline inwards that tell the level inside
  double reach_out = 7.0;         // likewise outwards, where patches end soon
  int levels_around = 12;         // where they vary: a side of a square has three
  int max_iterations = 12;        // until the outline moves by less than settled_px
  double settled_px = 1e-3;       // patch px
  double start_blur = 0.6;        // patch px, sigma of the lens: a sharp one
  double min_blur = 0.15;         // patch px: below it the pixel's width hides what the lens does
  double max_blur = 3.0;          // patch px: beyond it an outline is out of focus
  double block_px = 6.0;          // patch px of outline that are judged together
  double correlated_px = 22.0;    // of outline over which packed pixels err together: across a JPEG's block of colour
  double min_noise = 2e-3;        // of a pixel, 1 being the contrast: whole grey levels hide as much
  double varied_sigmas = 3.0;     // of a chi-square, beyond which the levels are taken to vary
  double outlier_sigmas = 4.5;    // of a block's place or noise, beyond it something may lie before the outline
  double outlier_px = 0.15;       // and if the block's place is off by this,
  double outlier_noise = 0.15;    // or its noise is this, 1 being the contrast, something does
  double min_kept = 0.7;          // of the blocks, over all
  double min_kept_quarter = 0.5;  // of the blocks of each quarter
  double min_contrast = 0.35;     // of a block, 1 being the average
  double max_move = 3.0;          // patch px that the outline may lie off the mask's
};

template <class Shape>
struct FittedContour {
  Shape shape;
  Eigen::Matrix<double, Shape::kSize, Shape::kSize> covariance;  // of the shape's parameters, patch px
  double blur = 0.0;                                             // patch px, sigma
  // Variance of the outline's place over what independent pixels explain; 1 where chance explains the rest.
  double roughness = 1.0;
};

// Fits `start`, which is within a pixel or so. `contrast` is 1 in the mark and 0 around it (mark_contrast). Nothing
// when the outline is not that shape, is hidden in part, or the patch ends at it.
template <class Shape>
std::optional<FittedContour<Shape>> fit_contour(const PlaneImage& contrast, const Shape& start,
                                                const ContourFitParameters& parameters);

}  // namespace markservo::target_locator
