#pragma once

// The centre of a flat mark in space, from its plane and where the images show it.

#include <Eigen/Core>
#include <optional>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/image/image_centre.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"

namespace markservo::target_locator {

struct CentreEstimate {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();         // m
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // m^2
  double misfit = 0.0;  // chi-square per degree of freedom of the two images' centres and the plane's disparity
};

// Least squares for (u_left, v, disparity) from the centre in one or both images and the plane's disparity there;
// where they contradict each other the covariance grows by their misfit. Nothing without a centre or in front.
std::optional<CentreEstimate> fuse_centres(const std::optional<ImageCentre>& left,
                                           const std::optional<ImageCentre>& right, const PlaneAlignment& alignment,
                                           const geometry::StereoCamera& camera);

}  // namespace markservo::target_locator
