#pragma once

// One outline in both views, and the place in space that it tells.
//
// Of a square and a ball the place in space is the unknown, and both outlines are what it predicts. A plane in space
// maps the left view to the right one by u_right = u - d(u, v), v_right = v with a disparity that is linear, so that of
// a disc the left outline and the disparity plane are the unknowns. Nothing is said of the mark's size.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/target-locator/contour/outline_measurements.hpp"
#include "services/target-locator/location.hpp"

namespace markservo::target_locator {

struct SharedOutlineParameters {
  double row_offset_sigma = 0.3;  // px that rectification leaves between the views' rows
  double floor_px = 0.0015;       // px that the model of an edge leaves of a view's place, whatever the noise
  double max_excess = 10.0;       // of the misfit over what chance explains: beyond it the views do not show one thing
  double most_hidden = 0.12;      // of a square's edge: beyond it what is left is taken for another thing
  double as_likely = 9.2;         // chi-square: sides that fit by less more may be the hidden one (99% of draws)
  double shape_tolerance = 0.06;  // relative, of the radii of a disc in space
  double shape_sigmas = 3.0;      // that the noise may add to it
};

struct OutlineEstimate {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();         // m, the mark's centre
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // m^2
  Eigen::Vector3d normal_C = Eigen::Vector3d::Zero();    // towards the cameras; zero for a ball
  std::vector<Match> matches;                            // corners, or points around
};

// Measures a square. Values: column and row of four corners in order around, of the same corners in both views. What of
// one side is hidden, in either view, shows by the other three: where two sides may be it, the middle is given, with
// both places in the covariance. Nothing when the views do not show a square of which most of every side is seen.
std::optional<OutlineEstimate> square_from_outlines(const SharedOutlineInput& input,
                                                    const SharedOutlineParameters& parameters);

// Measures a disc. Values: an ellipse's parameters (EllipseContour). Nothing when the views contradict each other, or
// their ellipse in space is no circle.
std::optional<OutlineEstimate> disc_from_outlines(const SharedOutlineInput& input,
                                                  const SharedOutlineParameters& parameters);

// Measures a ball, by the same values; nothing is said by texture. A sphere's outline is where a cone of lines of sight
// touches it.
std::optional<OutlineEstimate> ball_from_outlines(const SharedOutlineInput& input,
                                                  const SharedOutlineParameters& parameters);

}  // namespace markservo::target_locator
