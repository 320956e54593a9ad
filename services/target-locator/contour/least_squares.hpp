#pragma once

// Least squares for a handful of unknowns with derivatives by differences.

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace markservo::target_locator {

using VectorFunction = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd&)>;

// The function's derivatives by central differences with steps of `step` (one for each argument). Nothing where it has
// no value.
std::optional<Eigen::MatrixXd> derivatives_of(const VectorFunction& function, const Eigen::VectorXd& at,
                                              const Eigen::VectorXd& step);

struct LeastSquaresSolution {
  Eigen::VectorXd unknowns;
  Eigen::MatrixXd covariance;
  double chi_square = 0.0;
  double degrees_of_freedom = 0.0;
};

struct LeastSquaresProblem {
  VectorFunction predict;  // the measurements that unknowns would make
  Eigen::VectorXd measured;
  Eigen::MatrixXd information;  // of the measurements: the inverse of their covariance
  Eigen::VectorXd start;
  Eigen::VectorXd step;  // of the unknowns, for differences
};

// Solves by Gauss-Newton. Nothing when the measurements do not fix the unknowns, or where predict has no value.
std::optional<LeastSquaresSolution> solve_least_squares(const LeastSquaresProblem& problem);

}  // namespace markservo::target_locator
