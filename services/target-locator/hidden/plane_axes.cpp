#include "services/target-locator/hidden/plane_axes.hpp"

#include <Eigen/Geometry>

namespace markservo::target_locator {

PlaneAxes::PlaneAxes(const DisparityPlane& plane, const geometry::StereoCamera& camera)
    : plane_(plane), camera_(camera) {
  const Eigen::Vector3d normal = plane_normal(plane, camera);
  first_ = (Eigen::Vector3d::UnitX() - normal * normal.x()).normalized();
  second_ = first_.cross(normal);
  origin_ = point(plane.u0, plane.v0).value_or(Eigen::Vector3d::Zero());
}

std::optional<Eigen::Vector3d> PlaneAxes::point(double u_left, double v) const {
  return geometry::triangulate(camera_, {u_left, v, u_left - plane_.at(u_left, v)});
}

std::optional<Eigen::Vector2d> PlaneAxes::place(double u_left, double v) const {
  const auto p_C = point(u_left, v);
  if (!p_C) return std::nullopt;
  return Eigen::Vector2d(first_.dot(*p_C - origin_), second_.dot(*p_C - origin_));
}

std::optional<Eigen::Vector2d> PlaneAxes::image(const Eigen::Vector2d& place) const {
  const auto seen = geometry::project(camera_, origin_ + place.x() * first_ + place.y() * second_);
  if (!seen) return std::nullopt;
  return Eigen::Vector2d(seen->u_left, seen->v);
}

}  // namespace markservo::target_locator
