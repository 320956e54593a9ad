#pragma once

// One outline in both views, and the place in space that it tells.
//
// A plane in space maps the left view to the right one by u_right = u - d(u, v), v_right = v with a disparity that is
// linear, so that the left outline and the disparity plane are the unknowns, and the right outline is what they
// predict. Nothing is said of the mark's size.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"

namespace markservo::target_locator {

struct SharedOutlineParameters {
  double row_offset_sigma = 0.3;  // px that rectification leaves between the views' rows
  double floor_px = 0.0015;       // px that the model of an edge leaves of a view's place, whatever the noise
  double explained_misfit = 3.0;  // chi-square per degree of freedom that chance explains (99% of draws)
  double max_misfit = 30.0;       // beyond it the two views do not show one thing of that shape
  double shape_tolerance = 0.06;  // relative, of the sides of a square and the radii of a disc in space
  double shape_sigmas = 3.0;      // that the noise may add to it
};

// What one view shows: numbers that tell the outline, and their covariance, in px of the image.
struct OutlineInView {
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;
};

struct OutlineEstimate {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();         // m, the mark's centre
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // m^2
  Eigen::Vector3d normal_C = Eigen::Vector3d::Zero();    // towards the cameras; zero for a ball
  double misfit = 0.0;                                   // chi-square per degree of freedom
  std::vector<Match> matches;                            // corners, or points around
};

struct SharedOutlineInput {
  OutlineInView left;
  OutlineInView right;
  const geometry::StereoCamera& camera;
  std::optional<PlaneAlignment> texture;  // what texture says of the plane, to be fused with
};

// Measures a square. Values: column and row of four corners in order around, of the same corners in both views. Nothing
// when the views contradict each other, or their quadrangle in space is no square.
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
