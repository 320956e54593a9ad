#include "tests/experiments/localisation/gaussian_radius.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markservo::experiments {

double mean_radial_error(const Eigen::Matrix2d& covariance) {
  if (!covariance.allFinite()) throw std::invalid_argument("mean_radial_error: the covariance is not finite");
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance, Eigen::EigenvaluesOnly);
  const double most = solver.eigenvalues()[1];
  const double least = solver.eigenvalues()[0];
  if (least < -1e-9 * std::abs(most)) throw std::invalid_argument("mean_radial_error: the covariance is not positive");
  if (most <= 0.0) return 0.0;
  const double k = std::sqrt(std::clamp(1.0 - least / most, 0.0, 1.0));
  return std::sqrt(2.0 / M_PI * most) * std::comp_ellint_2(k);
}

}  // namespace markservo::experiments
