#include "services/target-locator/centre/centre_fusion.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace markservo::target_locator {
namespace {

using Rows = Eigen::Matrix<double, 2, 3>;

// Normal equations for (u, v, d): column and row in the left image, disparity there.
struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();

  // Measurements `value` = rows (u, v, d), with the inverse of their covariance.
  template <class Matrix, class Value, class Weight>
  void add(const Matrix& rows, const Value& value, const Weight& weight) {
    information += rows.transpose() * weight * rows;
    right_side += rows.transpose() * weight * value;
  }
};

// The plane is linear in (u, v), so that the system is linear as well: d - along_u u - along_v v = constant.
struct PlaneRow {
  Eigen::Matrix<double, 1, 3> row;
  Eigen::Matrix<double, 1, 1> value;
  double variance;  // px^2, of the disparity at `about`

  PlaneRow(const PlaneAlignment& alignment, const Eigen::Vector2d& about)
      : row(-alignment.plane.along_u, -alignment.plane.along_v, 1.0), value(alignment.plane.at(0.0, 0.0)) {
    const Eigen::Vector3d spread(1.0, about.x() - alignment.plane.u0, about.y() - alignment.plane.v0);
    variance = std::max(1e-12, spread.dot(alignment.covariance * spread));
  }
};

Rows left_rows() {
  Rows rows;
  rows << 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  return rows;
}

Rows right_rows() {
  Rows rows;
  rows << 1.0, 0.0, -1.0, 0.0, 1.0, 0.0;
  return rows;
}

}  // namespace

std::optional<CentreEstimate> fuse_centres(const std::optional<ImageCentre>& left,
                                           const std::optional<ImageCentre>& right, const PlaneAlignment& alignment,
                                           const geometry::StereoCamera& camera) {
  if (!left && !right) return std::nullopt;
  const Eigen::Vector2d about =
      left ? left->position : Eigen::Vector2d(right->position.x() + alignment.plane.at_centre, right->position.y());
  const PlaneRow plane(alignment, about);
  NormalEquations equations;
  equations.add(plane.row, plane.value, Eigen::Matrix<double, 1, 1>(1.0 / plane.variance));
  const Rows of_left = left_rows();
  const Rows of_right = right_rows();
  Eigen::Vector2d right_position = Eigen::Vector2d::Zero();
  if (left) equations.add(of_left, left->position, Eigen::Matrix2d(left->covariance.inverse()));
  if (right) {
    right_position = right->position - Eigen::Vector2d(0.0, alignment.row_offset);
    equations.add(of_right, right_position, Eigen::Matrix2d(right->covariance.inverse()));
  }
  const Eigen::Matrix3d covariance = equations.information.inverse();
  if (!covariance.allFinite()) return std::nullopt;
  const Eigen::Vector3d point = covariance * equations.right_side;

  CentreEstimate estimate;
  if (left && right) {
    const Eigen::Vector2d off_left = left->position - of_left * point;
    const Eigen::Vector2d off_right = right_position - of_right * point;
    const double off_plane = (plane.value - plane.row * point).value();
    const double chi_square = off_left.dot(left->covariance.inverse() * off_left) +
                              off_right.dot(right->covariance.inverse() * off_right) +
                              off_plane * off_plane / plane.variance;
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
