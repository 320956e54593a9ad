#include "services/target-locator/image/colour_projection.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace markservo::target_locator {
namespace {

constexpr ColourMap kGreyAxis{{0.17F, 0.88F, 0.45F}, 0.0F};  // luma's shares of B, G, R at unit length
constexpr int kRowStep = 2;                                  // rows looked at for colours: neighbours repeat each other
constexpr double kSameColour = 6.0;  // grey levels between mark and ring below which no outline can be measured

using imaging::ColourSums;

Eigen::Vector3d mean_of(const ColourSums& sums) {
  return {sums.mean(0), sums.mean(1), sums.mean(2)};
}

Eigen::Matrix3d covariance_of(const ColourSums& sums) {
  Eigen::Matrix3d covariance;
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) covariance(a, b) = covariance(b, a) = sums.covariance(a, b);
  }
  return covariance;
}

}  // namespace

MarkColours mark_colours(const Patch& patch, MarkMasks& masks) {
  make_ring(masks);
  MarkColours colours;
  const std::ptrdiff_t stride = std::ptrdiff_t{3} * patch.width;
  imaging::add_colours(patch.bgr, stride, masks.inner, kRowStep, colours.inside);
  imaging::add_colours(patch.bgr, stride, masks.ring, kRowStep, colours.around);
  return colours;
}

ColourMap texture_axis(const ColourSums& inside) {
  if (inside.count < 2) return kGreyAxis;
  const Eigen::Matrix3d covariance = covariance_of(inside);
  if (!(covariance.trace() > 1e-6)) return kGreyAxis;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  Eigen::Vector3d axis = solver.eigenvectors().col(2);
  if (!axis.allFinite()) return kGreyAxis;
  if (axis.sum() < 0.0) axis = -axis;
  const Eigen::Vector3f weights = axis.cast<float>();
  return {{weights[0], weights[1], weights[2]}, 0.0F};
}

Contrast mark_contrast(const MarkColours& colours) {
  Contrast contrast;
  if (colours.inside.count < 9 || colours.around.count < 9) return contrast;
  const Eigen::Vector3d outside = mean_of(colours.around);
  const Eigen::Vector3d gap = mean_of(colours.inside) - outside;
  if (gap.norm() < kSameColour) return contrast;
  // The ridge keeps noise-free pictures solvable and is the variance of rounding to whole grey levels, and then some.
  const Eigen::Matrix3d within =
      covariance_of(colours.inside) + covariance_of(colours.around) + 2.0 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d weights = within.inverse() * gap;
  const double span = weights.dot(gap);
  if (!(span > 0.0) || !weights.allFinite()) return contrast;
  weights /= span;
  const Eigen::Vector3f w = weights.cast<float>();
  contrast.map = {{w[0], w[1], w[2]}, static_cast<float>(-weights.dot(outside))};
  contrast.valid = true;
  return contrast;
}

void project_colours(const Patch& patch, const ColourMap& map, PlaneImage& plane) {
  project_pixels(patch.bgr, patch.width, patch.height, map, plane);
}

}  // namespace markservo::target_locator
