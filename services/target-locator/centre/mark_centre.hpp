#pragma once

// The centre of a flat mark in space, from its plane and its outlines in both images.

#include <Eigen/Core>
#include <optional>

#include "services/target-locator/outline/square_outline.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"

namespace markservo::target_locator {

// A centre in one image.
struct ImageCentre {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    // px
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // px^2
};

enum class CameraSide { kLeft, kRight };

// Where the image shows the mark's centre, by the mask alone: its pixels weighted by Z^3, which is the area of the
// plane that a pixel covers, so that the nearer half of a slanted mark does not count more than the farther one.
// `camera` is used for its principal points only. Nothing for an empty mask or a plane that is not in front of the
// cameras.
std::optional<ImageCentre> centre_of_mask(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                          const geometry::StereoCamera& camera, CameraSide side);

// What the mask covers of the plane in space, m^2. Nothing where centre_of_mask gives nothing.
std::optional<double> area_on_plane(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                    const geometry::StereoCamera& camera, CameraSide side);

// The unit normal of the plane that shows these disparities, towards the cameras.
Eigen::Vector3d plane_normal(const DisparityPlane& plane, const geometry::StereoCamera& camera);

// Corners of an outline in the left image, on the plane in space: lengths of its four sides, m. Nothing when a corner
// is not in front of the cameras.
std::optional<Eigen::Vector4d> side_lengths(const SquareOutline& outline, const DisparityPlane& plane,
                                            const geometry::StereoCamera& camera);

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
