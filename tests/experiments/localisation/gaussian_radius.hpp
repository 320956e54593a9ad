#pragma once

#include <Eigen/Core>

namespace markservo::experiments {

// The mean length (m) of a Gaussian error with this covariance (m^2) and mean zero: sqrt(2 / pi) * a * E(k) with a the
// greater standard deviation, E the complete elliptic integral of the second kind and k^2 = 1 - (b / a)^2.
// Throws std::invalid_argument if the covariance is not finite or has an eigenvalue clearly below 0.
double mean_radial_error(const Eigen::Matrix2d& covariance);

}  // namespace markservo::experiments
