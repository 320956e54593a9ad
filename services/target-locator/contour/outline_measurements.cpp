#include "services/target-locator/contour/outline_measurements.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

#include "services/target-locator/contour/chance.hpp"

namespace markservo::target_locator {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd inverse_of(const MatrixXd& covariance) {
  return covariance.ldlt().solve(MatrixXd::Identity(covariance.rows(), covariance.cols()));
}

Index rows_of(Index values, const std::optional<PlaneAlignment>& texture) {
  return 2 * values + 1 + (texture ? 3 : 0);
}

}  // namespace

Misfit::Misfit(double chi_square_in, double degrees_of_freedom, bool rough) : chi_square(chi_square_in) {
  const double mean = chi_square / degrees_of_freedom;
  excess = mean / explained_by_chance(degrees_of_freedom);
  growth = std::max(1.0, rough ? mean : excess);
}

OutlineInView with_floor(OutlineInView view, Index points, double floor_px) {
  for (Index i = 0; i < points; ++i) {
    for (Index k = 0; k < points; ++k) {
      view.covariance(2 * i, 2 * k) += floor_px * floor_px;
      view.covariance(2 * i + 1, 2 * k + 1) += floor_px * floor_px;
    }
  }
  return view;
}

LeastSquaresProblem measured_by(const SharedOutlineInput& input, double row_offset_sigma) {
  const Index n = input.left.values.size();
  const Index rows = rows_of(n, input.texture);
  LeastSquaresProblem problem;
  problem.measured = VectorXd::Zero(rows);
  problem.measured.head(n) = input.left.values;
  problem.measured.segment(n, n) = input.right.values;
  problem.information = MatrixXd::Zero(rows, rows);
  problem.information.topLeftCorner(n, n) = inverse_of(input.left.covariance);
  problem.information.block(n, n, n, n) = inverse_of(input.right.covariance);
  problem.information(2 * n, 2 * n) = 1.0 / (row_offset_sigma * row_offset_sigma);
  if (input.texture) {
    const DisparityPlane& plane = input.texture->plane;
    problem.measured.tail<3>() << plane.at_centre, plane.along_u, plane.along_v;
    problem.information.bottomRightCorner<3, 3>() = input.texture->covariance.inverse();
  }
  return problem;
}

VectorXd stacked(const OutlinePrediction& predicted, const std::optional<PlaneAlignment>& texture) {
  const Index n = predicted.left.size();
  VectorXd stack(rows_of(n, texture));
  stack.head(n) = predicted.left;
  stack.segment(n, n) = predicted.right;
  stack[2 * n] = predicted.row_offset;
  if (texture) {
    const DisparityPlane& plane = predicted.plane;
    stack.tail<3>() << plane.at(texture->plane.u0, texture->plane.v0), plane.along_u, plane.along_v;
  }
  return stack;
}

}  // namespace markservo::target_locator
