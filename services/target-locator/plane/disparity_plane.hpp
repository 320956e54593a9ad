#pragma once

// The disparities of a plane in space.

#include <Eigen/Core>

#include "common/geometry/stereo_camera.hpp"

namespace markservo::target_locator {

// Disparity u_left - u_right (image px) over the left image. A plane in space has exactly this form.
struct DisparityPlane {
  double u0 = 0.0;         // px, left image: where `at_centre` holds
  double v0 = 0.0;         // px
  double at_centre = 0.0;  // px
  double along_u = 0.0;    // px per px
  double along_v = 0.0;    // px per px

  double at(double u, double v) const { return at_centre + along_u * (u - u0) + along_v * (v - v0); }
};

// The plane's normal away from the cameras in C, fx baseline / distance long (px), the distance being the plane's from
// C's origin.
Eigen::Vector3d disparity_normal(const DisparityPlane& plane, const geometry::StereoCamera& camera);

// The unit normal of the plane that shows these disparities, towards the cameras.
Eigen::Vector3d plane_normal(const DisparityPlane& plane, const geometry::StereoCamera& camera);

}  // namespace markservo::target_locator
