#pragma once

// Metric coordinates on a mark's plane in space.

#include <Eigen/Core>
#include <optional>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/plane/disparity_plane.hpp"

namespace markservo::target_locator {

// The first axis lies as far along the images' rows as it can; the origin is where the plane's (u0, v0) is seen.
class PlaneAxes {
 public:
  // Refers to both.
  PlaneAxes(const DisparityPlane& plane, const geometry::StereoCamera& camera);

  // m; nothing where the plane is not in front of the cameras.
  std::optional<Eigen::Vector2d> place(double u_left, double v) const;
  // Where the left image shows a place, px; nothing for what is not in front of the cameras.
  std::optional<Eigen::Vector2d> image(const Eigen::Vector2d& place) const;
  // m, of the origin; 0 if it is not in front of the cameras.
  double depth() const { return origin_.y(); }

 private:
  std::optional<Eigen::Vector3d> point(double u_left, double v) const;

  const DisparityPlane& plane_;
  const geometry::StereoCamera& camera_;
  Eigen::Vector3d first_;   // in C
  Eigen::Vector3d second_;  // in C
  Eigen::Vector3d origin_;  // m, in C
};

}  // namespace markservo::target_locator
