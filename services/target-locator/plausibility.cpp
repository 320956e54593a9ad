#include "services/target-locator/plausibility.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace markservo::target_locator {
namespace {

constexpr int kSmallestPatch = 8;        // patch px along each axis
constexpr double kLeastSizeRatio = 0.4;  // of the boxes' widths and heights: slant and what hides
constexpr double kMostRowsApart = 0.5;   // of the taller box, between the boxes' middles
constexpr double kFarthest = 1e4;        // m along each axis: nothing a robot sees is farther, and no message says so
constexpr double kLeastKnown = 4e5;      // m^2, of a coordinate: likewise
constexpr double kRounding = 1e-10;      // of the largest eigenvalue: what rounding leaves of a zero

// Cameras beyond all measure make numbers of which rounding leaves none.
bool is_covariance(const Eigen::Matrix3d& matrix) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(matrix / matrix.cwiseAbs().maxCoeff(), Eigen::EigenvaluesOnly);
  return solver.info() == Eigen::Success && solver.eigenvalues().minCoeff() >= -kRounding;
}

}  // namespace

bool valid_camera(const geometry::StereoCamera& camera) {
  return std::isfinite(camera.fx) && std::isfinite(camera.fy) && std::isfinite(camera.cx_left) &&
         std::isfinite(camera.cx_right) && std::isfinite(camera.cy) && std::isfinite(camera.baseline) &&
         camera.fx > 0.0 && camera.fy > 0.0 && camera.baseline > 0.0;
}

bool is_usable(const View& view) {
  const PatchFrame& frame = view.patch.frame;
  return !view.patch.empty() && view.patch.width >= kSmallestPatch && view.patch.height >= kSmallestPatch &&
         frame.scale > 0.0 && std::isfinite(frame.x) && std::isfinite(frame.y) && view.width > 0.0 && view.height > 0.0;
}

bool boxes_agree(const View& left, const View& right, const geometry::StereoCamera& camera) {
  const double height = std::max(left.height, right.height);
  if (std::min(left.height, right.height) < kLeastSizeRatio * height) return false;
  if (std::min(left.width, right.width) < kLeastSizeRatio * std::max(left.width, right.width)) return false;
  if (std::abs(left.centre_v() - right.centre_v()) > kMostRowsApart * height) return false;
  return (left.centre_u() - camera.cx_left) - (right.centre_u() - camera.cx_right) > 0.0;
}

bool is_possible(const Location& location) {
  const auto& p_C = location.p_C;
  const Eigen::Array3d variances = location.covariance.diagonal();
  return p_C.allFinite() && p_C.y() > 0.0 && p_C.cwiseAbs().maxCoeff() <= kFarthest &&
         location.covariance.allFinite() && variances.minCoeff() > 0.0 && variances.maxCoeff() <= kLeastKnown &&
         is_covariance(location.covariance) && location.normal_C.allFinite();
}

}  // namespace markservo::target_locator
