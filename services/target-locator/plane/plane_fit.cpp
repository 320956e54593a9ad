#include "services/target-locator/plane/plane_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace markservo::target_locator {
namespace {

// Standard deviation of what is no outlier.
double robust_sigma(const PlaneTemplate& t, const std::vector<float>& residual) {
  constexpr double kMeanOfNormal = 0.7979;  // of |x| for sigma 1
  constexpr double kCut = 2.5;
  constexpr double kMeanOfCutNormal = 0.7724;  // for |x| up to kCut
  const double all = mean_absolute(t, residual.data(), std::numeric_limits<float>::max()).mean / kMeanOfNormal;
  return mean_absolute(t, residual.data(), static_cast<float>(kCut * all)).mean / kMeanOfCutNormal;
}

}  // namespace

Vector6 parameters_of(const DisparityPlane& plane, const PlaneTemplate& t) {
  const PlaneTemplate::Origin& origin = t.origin;
  Vector6 p;
  p << plane.at(origin.u, origin.v), plane.along_u * origin.extent, plane.along_v * origin.extent, 1.0, 0.0, 0.0;
  return p;
}

DisparityPlane plane_of(const Vector6& parameters, const PlaneTemplate& t) {
  const PlaneTemplate::Origin& origin = t.origin;
  return {origin.u, origin.v, parameters[0], parameters[1] / origin.extent, parameters[2] / origin.extent};
}

PlaneFit::PlaneFit(const StereoPatch& patch, PlaneTemplates& templates, PlaneTemplate& pixels)
    : patch_(patch), pixels_(pixels), warped_(templates.warped), residual_(templates.residual) {
  factorise();
}

bool PlaneFit::iterate(const Vector6& start, const FitLimits& limits) {
  const Vector6 begin = start;  // which may be the parameters themselves
  parameters_ = begin;
  for (int k = 0; k < limits.iterations; ++k) {
    evaluate();
    const Vector6 change = -solver_.solve(right_side_);
    if (!change.allFinite()) return false;
    parameters_ += change;
    if (!((parameters_ - begin).head<3>().cwiseAbs().sum() < 3.0 * limits.max_change_px)) return false;
    // Residuals of a step that changes the light say nothing.
    constexpr double kSettledOffset = 0.5;  // grey levels
    if (change.head<3>().cwiseAbs().sum() < limits.settled_px && std::abs(change[4]) < kSettledOffset) break;
  }
  return true;
}

double PlaneFit::drop_outliers(double sigmas) {
  const double limit = std::max(2.0, sigmas * robust_sigma(pixels_, residual_));
  const std::size_t kept = drop_above(residual_.data(), static_cast<float>(limit), pixels_);
  if (kept < pixels_.size()) factorise();
  return static_cast<double>(kept) / static_cast<double>(pixels_.size());
}

double PlaneFit::correlation() const {
  return correlation_of(pixels_, warped_);
}

std::optional<Matrix6> PlaneFit::covariance(double noise_correlation) const {
  const double variance = noise_correlation * sum_of_squares_ / std::max(1.0, normal_.count - kPlaneParameters);
  const Matrix6 inverse = solver_.inverse();
  const Matrix6 covariance = variance * inverse * normal_.information * inverse.transpose();
  if (!covariance.allFinite()) return std::nullopt;
  return covariance;
}

PlaneFit::NormalMatrices PlaneFit::normal_matrices(const PlaneTemplate& t) {
  const DerivativeSums derivatives = sum_derivatives(t);
  NormalMatrices sums;
  for (int row = 0; row < kPlaneParameters; ++row) {
    const auto r = static_cast<std::size_t>(row);
    for (int column = 0; column < kPlaneParameters; ++column) {
      sums.information(row, column) = derivatives.information[r][static_cast<std::size_t>(column)];
      sums.newton(row, column) =
          column < 3 ? derivatives.cross[r][static_cast<std::size_t>(column)] : sums.information(row, column);
    }
  }
  sums.count = sums.information(4, 4);  // the offset's derivative is 1 at every pixel
  return sums;
}

void PlaneFit::factorise() {
  normal_ = normal_matrices(pixels_);
  solvable_ = normal_.count >= 3.0 * kPlaneParameters;
  solver_.compute(normal_.newton);
}

void PlaneFit::evaluate() {
  warp(patch_, pixels_, plane_of(parameters_, pixels_), warped_);
  residual_.resize(pixels_.padded());
  const ResidualSums sums =
      sum_residuals(pixels_, warped_.data(), static_cast<float>(parameters_[3]), static_cast<float>(parameters_[4]),
                    static_cast<float>(parameters_[5]), residual_.data());
  right_side_ = Vector6::Map(sums.products.data());
  sum_of_squares_ = sums.squares;
}

}  // namespace markservo::target_locator
