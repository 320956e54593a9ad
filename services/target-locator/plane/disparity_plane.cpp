#include "services/target-locator/plane/disparity_plane.hpp"

namespace markservo::target_locator {

Eigen::Vector3d disparity_normal(const DisparityPlane& plane, const geometry::StereoCamera& camera) {
  // n . p = c and p = Z (x, 1, z) give f B n . (x, 1, z) = c disparity, which is linear in the image.
  const double ahead = plane.at(camera.cx_left, camera.cy) - (camera.cx_left - camera.cx_right);
  return {plane.along_u * camera.fx, ahead, -plane.along_v * camera.fy};
}

Eigen::Vector3d plane_normal(const DisparityPlane& plane, const geometry::StereoCamera& camera) {
  const Eigen::Vector3d away = disparity_normal(plane, camera);
  const double length = away.norm();
  return length > 0.0 ? Eigen::Vector3d(-away / length) : Eigen::Vector3d::Zero();
}

}  // namespace markservo::target_locator
