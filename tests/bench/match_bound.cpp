#include "tests/bench/match_bound.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace markservo::bench {
namespace {

constexpr double kSpan = 40.0;  // px, to which slopes are taken so that the numbers stay of one order

// Of the right view's greys by (disparity, slope along u, slope along v, gain, offset).
using Derivatives = Eigen::Matrix<double, 5, 1>;
using Information = Eigen::Matrix<double, 5, 5>;

Information information(const NoiseFreeView& view, const target_locator::Mask& window, double column, double row) {
  Information sum = Information::Zero();
  for (int y = 0; y < window.height(); ++y) {
    for (int x = 0; x < window.width(); ++x) {
      if (!window.test(x, y)) continue;
      const auto gradient = static_cast<double>(view.change_along_u.at(x, y));
      Derivatives d;
      d << gradient, gradient * (x - column) / kSpan, gradient * (y - row) / kSpan,
          static_cast<double>(view.grey.at(x, y)) / 100.0, 1.0;
      sum += d * d.transpose();
    }
  }
  return sum;
}

// Both views have the noise, so that their difference has twice its variance.
double bound(double inverse, double sigma) {
  const double variance = 2.0 * sigma * sigma * inverse;
  return variance > 0.0 && std::isfinite(variance) ? std::sqrt(variance) : std::numeric_limits<double>::infinity();
}

}  // namespace

double disparity_bound(const NoiseFreeView& view, const target_locator::Mask& window, double sigma) {
  const Information all = information(view, window, 0.0, 0.0);
  Eigen::Matrix3d of_disparity_gain_offset;
  constexpr int kUsed[] = {0, 3, 4};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) of_disparity_gain_offset(i, j) = all(kUsed[i], kUsed[j]);
  }
  return bound(of_disparity_gain_offset.inverse()(0, 0), sigma);
}

double plane_bound(const NoiseFreeView& view, const target_locator::Mask& window, double sigma, double column,
                   double row) {
  return bound(information(view, window, column, row).inverse()(0, 0), sigma);
}

}  // namespace markservo::bench
