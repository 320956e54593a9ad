#pragma once

// What two views of one outline, and texture where there is some, measure: one stack for least squares.

#include <Eigen/Core>
#include <optional>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/contour/least_squares.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"

namespace markservo::target_locator {

// What one view shows: numbers that tell the outline, and their covariance, in px of the image.
struct OutlineInView {
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;
  bool rough = false;  // its pixels err together, so that the covariance is an estimate
};

struct SharedOutlineInput {
  OutlineInView left;
  OutlineInView right;
  const geometry::StereoCamera& camera;
  std::optional<PlaneAlignment> texture;  // what texture says of the plane, to be fused with

  bool rough() const { return left.rough || right.rough; }
};

// How a misfit compares with what chance explains.
struct Misfit {
  double chi_square = 0.0;
  double excess = 0.0;  // over what chance explains
  double growth = 1.0;  // of the covariance: up to what chance explains a covariance that is known stands

  Misfit(double chi_square, double degrees_of_freedom, bool rough);
};

// The outline of both views and the plane that some unknowns would make.
struct OutlinePrediction {
  Eigen::VectorXd left;
  Eigen::VectorXd right;
  double row_offset = 0.0;  // px, what the right view lies lower than the rows say
  DisparityPlane plane;     // asked where there is texture
};

// The view with `floor_px` more of doubt, alike in the columns and alike in the rows of its first `points` points.
OutlineInView with_floor(OutlineInView view, Eigen::Index points, double floor_px);

// The measurements and their information: the left view's, the right view's, a row offset of 0 known to
// `row_offset_sigma` px, and the texture's plane.
LeastSquaresProblem measured_by(const SharedOutlineInput& input, double row_offset_sigma);

// The prediction in the same order.
Eigen::VectorXd stacked(const OutlinePrediction& predicted, const std::optional<PlaneAlignment>& texture);

}  // namespace markservo::target_locator
