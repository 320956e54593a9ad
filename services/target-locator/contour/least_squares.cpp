#include "services/target-locator/contour/least_squares.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace markservo::target_locator {

std::optional<Eigen::MatrixXd> derivatives_of(const VectorFunction& function, const Eigen::VectorXd& at,
                                              const Eigen::VectorXd& step) {
  Eigen::MatrixXd jacobian;
  Eigen::VectorXd moved = at;
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    moved[k] = at[k] + step[k];
    const auto ahead = function(moved);
    moved[k] = at[k] - step[k];
    const auto behind = function(moved);
    moved[k] = at[k];
    if (!ahead || !behind) return std::nullopt;
    if (jacobian.size() == 0) jacobian.resize(ahead->size(), at.size());
    jacobian.col(k) = (*ahead - *behind) / (2.0 * step[k]);
  }
  return jacobian;
}

std::optional<LeastSquaresSolution> solve_least_squares(const LeastSquaresProblem& problem) {
  constexpr int kIterations = 6;  // the models are nearly linear over what they have to correct
  // Of the normal equations in steps of the unknowns, below which rounding decides.
  constexpr double kLeastReciprocalCondition = 1e-12;
  LeastSquaresSolution solution;
  solution.unknowns = problem.start;
  solution.degrees_of_freedom = static_cast<double>(problem.measured.size() - problem.start.size());
  for (int k = 0; k <= kIterations; ++k) {
    const auto predicted = problem.predict(solution.unknowns);
    if (!predicted) return std::nullopt;
    const Eigen::VectorXd residual = problem.measured - *predicted;
    solution.chi_square = residual.dot(problem.information * residual);
    if (!std::isfinite(solution.chi_square)) return std::nullopt;
    if (k == kIterations) break;
    const auto jacobian = derivatives_of(problem.predict, solution.unknowns, problem.step);
    if (!jacobian) return std::nullopt;
    const auto in_steps = problem.step.asDiagonal();
    const Eigen::MatrixXd by_steps = *jacobian * in_steps;
    const Eigen::MatrixXd weighted = by_steps.transpose() * problem.information;
    const Eigen::LDLT<Eigen::MatrixXd> solver(weighted * by_steps);
    if (solver.info() != Eigen::Success || !solver.isPositive()) return std::nullopt;
    if (!(solver.rcond() > kLeastReciprocalCondition)) return std::nullopt;
    const Eigen::VectorXd change = in_steps * solver.solve(weighted * residual);
    if (!change.allFinite()) return std::nullopt;
    solution.unknowns += change;
    const Eigen::MatrixXd inverse = solver.solve(Eigen::MatrixXd::Identity(problem.start.size(), problem.start.size()));
    solution.covariance = in_steps * inverse * in_steps;
  }
  if (!solution.covariance.allFinite()) return std::nullopt;
  return solution;
}

}  // namespace markservo::target_locator
