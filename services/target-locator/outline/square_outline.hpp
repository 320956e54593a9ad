#pragma once

// The four sides of a square mark in one image, to a few hundredths of a pixel.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "services/target-locator/image/patch_frame.hpp"
#include "services/target-locator/image/plane_image.hpp"
#include "services/target-locator/outline/square_side.hpp"

namespace markservo::target_locator {

struct OutlineParameters {
  double min_squareness = 0.5;     // fourth moment of the mask's shape, 1 for a square, 0 for a disc
  double centre_floor_px = 0.025;  // patch px, what is left of the centre's error whatever the scatter
  SideParameters side;
};

struct SquareOutline {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();      // px of the image: where the diagonals meet, which is the
                                                         // image of the square's centre also in perspective
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // px^2, of the centre
  std::array<Eigen::Vector2d, 4> corners;                // px of the image, in order around
  double worst_rms_px = 0.0;                             // patch px, of the worst side
};

// Fits the outline to the contrast between mark and surroundings, starting from the mask. `contrast` is 1 in the mark
// and 0 around it (mark_contrast). Nothing when the mask is no square, a side is hidden or the patch ends at it.
std::optional<SquareOutline> fit_square(const PlaneImage& contrast, const Mask& mask, const PatchFrame& frame,
                                        const OutlineParameters& parameters);

}  // namespace markservo::target_locator
