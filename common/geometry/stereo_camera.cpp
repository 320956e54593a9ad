#include "common/geometry/stereo_camera.hpp"

#include <stdexcept>
#include <string>

namespace markservo::geometry {

std::optional<StereoPoint> project(const StereoCamera& camera, const Eigen::Vector3d& p_C) {
  const double depth = p_C.y();
  if (!(depth > 0.0)) return std::nullopt;
  StereoPoint point;
  point.u_left = camera.cx_left + camera.fx * p_C.x() / depth;
  point.u_right = camera.cx_right + camera.fx * (p_C.x() - camera.baseline) / depth;
  point.v = camera.cy - camera.fy * p_C.z() / depth;
  return point;
}

std::optional<Eigen::Vector3d> triangulate(const StereoCamera& camera, const StereoPoint& point) {
  const double disparity = camera.disparity(point);
  if (!(disparity > 0.0)) return std::nullopt;
  const double depth = camera.fx * camera.baseline / disparity;
  return Eigen::Vector3d((point.u_left - camera.cx_left) * depth / camera.fx, depth,
                         -(point.v - camera.cy) * depth / camera.fy);
}

Eigen::Matrix3d triangulation_jacobian(const StereoCamera& camera, const StereoPoint& point) {
  const double disparity = camera.disparity(point);
  const auto p_C = triangulate(camera, point);
  if (!p_C) {
    throw std::invalid_argument("triangulation_jacobian: disparity is " + std::to_string(disparity) +
                                " px; allowed: above 0");
  }
  const double depth = p_C->y();
  Eigen::Matrix3d jacobian;
  jacobian.col(0) << depth / camera.fx, 0.0, 0.0;
  jacobian.col(1) << 0.0, 0.0, -depth / camera.fy;
  jacobian.col(2) = -*p_C / disparity;
  return jacobian;
}

}  // namespace markservo::geometry
