#pragma once

// The middle of what is seen of an object that is no plane.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/location.hpp"

namespace markservo::target_locator {

struct CloudCentre {
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();         // m, mean of the points that are not outliers in depth
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // m^2, of that mean as a sample of the surface
  int num_points = 0;
};

// Triangulates the matches and averages those within 3 robust sigmas of the median depth. Nothing without a point in
// front of the cameras.
std::optional<CloudCentre> centre_of_points(const std::vector<Match>& matches, const geometry::StereoCamera& camera);

}  // namespace markservo::target_locator
