#include "services/target-locator/outline/moment_square.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <cstddef>

#include "services/target-locator/image/mask_moments.hpp"

namespace markservo::target_locator {

std::optional<Lines> lines_from_moments(const Mask& mask, double min_squareness) {
  const MaskMoments m = moments_of(mask);
  if (m.n < 64.0) return std::nullopt;
  Eigen::Matrix2d moments;
  moments << m.xx, m.xy, m.xy, m.yy;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(moments);
  if (!(solver.eigenvalues()[0] > 1.0)) return std::nullopt;
  const Eigen::Matrix2d whiten = solver.operatorInverseSqrt();
  // The mean of (x' + i y')^4, with (x', y') whitened: (p x + q y)^4.
  const std::complex<double> p(whiten(0, 0), whiten(1, 0));
  const std::complex<double> q(whiten(0, 1), whiten(1, 1));
  const std::complex<double> fourth = p * p * p * p * m.fourth[0] + 4.0 * p * p * p * q * m.fourth[1] +
                                      6.0 * p * p * q * q * m.fourth[2] + 4.0 * p * q * q * q * m.fourth[3] +
                                      q * q * q * q * m.fourth[4];
  constexpr double kSquare = 2.4;  // |mean of (x + iy)^4| of a square with unit second moments
  if (std::abs(fourth) < kSquare * min_squareness) return std::nullopt;
  const double turn = std::arg(-fourth) / 4.0;
  Lines lines;
  for (std::size_t k = 0; k < 4; ++k) {
    const double angle = turn + 0.5 * M_PI * static_cast<double>(k);
    const Eigen::Vector2d normal = whiten * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    lines[k] = {normal, std::sqrt(3.0) + normal.dot(m.centre)};
  }
  return lines;
}

}  // namespace markservo::target_locator
