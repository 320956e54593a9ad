#include "services/target-locator/centre/mark_centre.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace markservo::target_locator {
namespace {

// What a mask's centroid is uncertain by: its outline is known to half a pixel, and opposite sides may err alike.
constexpr double kMaskCentreSigma = 0.3;  // patch px

// Sums over the mask with weights Z^3, Z in units of fx * baseline (1 / disparity).
struct MaskSums {
  double weight = 0.0;
  double depth =
      0.0;         // of weight * Z; the centre in space is the mean of Z times the ray, its image that over the mean Z
  double u = 0.0;  // of weight * Z * u
  double v = 0.0;  // of weight * Z * v
};

std::optional<MaskSums> sum_over_mask(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                      const geometry::StereoCamera& camera, CameraSide side) {
  const double shift = camera.cx_left - camera.cx_right;
  // A right pixel's disparity is the plane's at u_left = u_right + disparity, solved for the disparity.
  const double stretch = side == CameraSide::kLeft ? 1.0 : 1.0 / (1.0 - plane.along_u);
  MaskSums sums;
  for (int y = 0; y < mask.height(); ++y) {
    if (mask.surely_empty(y)) continue;
    const double v = frame.v_of(y);
    for (int x = mask.next(y, 0, true); x < mask.width(); x = mask.next(y, x + 1, true)) {
      const double u = frame.u_of(x);
      const double disparity = plane.at(u, v) * stretch - shift;
      if (!(disparity > 0.0)) return std::nullopt;
      const double depth = 1.0 / disparity;
      const double weight = depth * depth * depth;
      sums.weight += weight;
      sums.depth += weight * depth;
      sums.u += weight * depth * u;
      sums.v += weight * depth * v;
    }
  }
  if (!(sums.weight > 0.0)) return std::nullopt;
  return sums;
}

}  // namespace

std::optional<ImageCentre> centre_of_mask(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                          const geometry::StereoCamera& camera, CameraSide side) {
  const auto sums = sum_over_mask(mask, frame, plane, camera, side);
  if (!sums) return std::nullopt;
  ImageCentre centre;
  centre.position << sums->u / sums->depth, sums->v / sums->depth;
  centre.covariance = Eigen::Matrix2d::Identity() * std::pow(kMaskCentreSigma * frame.scale, 2);
  return centre;
}

std::optional<double> area_on_plane(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                    const geometry::StereoCamera& camera, CameraSide side) {
  const auto sums = sum_over_mask(mask, frame, plane, camera, side);
  if (!sums) return std::nullopt;
  // A pixel covers Z^3 / (fx fy c) of the plane n . p = c, with Z = fx B / disparity.
  const double ahead = plane.at(camera.cx_left, camera.cy) - (camera.cx_left - camera.cx_right);
  const Eigen::Vector3d away(plane.along_u * camera.fx, ahead, -plane.along_v * camera.fy);
  const double distance = camera.fx * camera.baseline / away.norm();
  const double unit = std::pow(camera.fx * camera.baseline, 3);
  return sums->weight * unit * frame.scale * frame.scale / (camera.fx * camera.fy * distance);
}

Eigen::Vector3d plane_normal(const DisparityPlane& plane, const geometry::StereoCamera& camera) {
  // n . p = c and p = Z (x, 1, z) give f B n . (x, 1, z) = c disparity, which is linear in the image.
  const double ahead = plane.at(camera.cx_left, camera.cy) - (camera.cx_left - camera.cx_right);
  const Eigen::Vector3d away(plane.along_u * camera.fx, ahead, -plane.along_v * camera.fy);
  const double length = away.norm();
  return length > 0.0 ? Eigen::Vector3d(-away / length) : Eigen::Vector3d::Zero();
}

std::optional<Eigen::Vector4d> side_lengths(const SquareOutline& outline, const DisparityPlane& plane,
                                            const geometry::StereoCamera& camera) {
  std::array<Eigen::Vector3d, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d& image = outline.corners[k];
    const auto p_C = geometry::triangulate(camera, {image.x(), image.y(), image.x() - plane.at(image.x(), image.y())});
    if (!p_C) return std::nullopt;
    corners[k] = *p_C;
  }
  Eigen::Vector4d lengths;
  for (std::size_t k = 0; k < 4; ++k) lengths[static_cast<int>(k)] = (corners[(k + 1) % 4] - corners[k]).norm();
  return lengths;
}

std::optional<CentreEstimate> fuse_centres(const std::optional<ImageCentre>& left,
                                           const std::optional<ImageCentre>& right, const PlaneAlignment& alignment,
                                           const geometry::StereoCamera& camera) {
  if (!left && !right) return std::nullopt;
  const DisparityPlane& plane = alignment.plane;
  // Unknowns (u, v, d): column and row in the left image, disparity there. The plane is linear in (u, v), so that the
  // system is linear as well: d - along_u u - along_v v = constant.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  double chi_square = 0.0;
  const auto add = [&](const auto& rows, const auto& value, const auto& weight) {
    information += rows.transpose() * weight * rows;
    right_side += rows.transpose() * weight * value;
  };
  const Eigen::Vector2d about =
      left ? left->position : Eigen::Vector2d(right->position.x() + plane.at_centre, right->position.y());
  const Eigen::Vector3d spread(1.0, about.x() - plane.u0, about.y() - plane.v0);
  const double disparity_variance = std::max(1e-12, spread.dot(alignment.covariance * spread));
  Eigen::Matrix<double, 1, 3> plane_row(-plane.along_u, -plane.along_v, 1.0);
  Eigen::Matrix<double, 1, 1> plane_value(plane.at(0.0, 0.0));
  add(plane_row, plane_value, Eigen::Matrix<double, 1, 1>(1.0 / disparity_variance));
  Eigen::Matrix<double, 2, 3> left_rows;
  left_rows << 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  Eigen::Matrix<double, 2, 3> right_rows;
  right_rows << 1.0, 0.0, -1.0, 0.0, 1.0, 0.0;
  Eigen::Vector2d right_position = Eigen::Vector2d::Zero();
  if (left) add(left_rows, left->position, Eigen::Matrix2d(left->covariance.inverse()));
  if (right) {
    right_position = right->position - Eigen::Vector2d(0.0, alignment.row_offset);
    add(right_rows, right_position, Eigen::Matrix2d(right->covariance.inverse()));
  }
  const Eigen::Matrix3d covariance = information.inverse();
  if (!covariance.allFinite()) return std::nullopt;
  const Eigen::Vector3d point = covariance * right_side;

  CentreEstimate estimate;
  if (left && right) {
    const Eigen::Vector2d off_left = left->position - left_rows * point;
    const Eigen::Vector2d off_right = right_position - right_rows * point;
    const double off_plane = (plane_value - plane_row * point).value();
    chi_square = off_left.dot(left->covariance.inverse() * off_left) +
                 off_right.dot(right->covariance.inverse() * off_right) + off_plane * off_plane / disparity_variance;
    estimate.misfit = chi_square / 2.0;  // five measurements, three unknowns
  }
  const geometry::StereoPoint stereo{point.x(), point.y(), point.x() - point.z()};
  const auto p_C = geometry::triangulate(camera, stereo);
  if (!p_C) return std::nullopt;
  const Eigen::Matrix3d jacobian = geometry::triangulation_jacobian(camera, stereo);
  estimate.p_C = *p_C;
  // Up to a chi-square that chance explains (99% of draws) the stated covariance stands.
  constexpr double kExplainedByChance = 4.6;
  estimate.covariance =
      jacobian * covariance * jacobian.transpose() * std::max(1.0, estimate.misfit / kExplainedByChance);
  return estimate;
}

}  // namespace markservo::target_locator
