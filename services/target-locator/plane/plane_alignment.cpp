#include "services/target-locator/plane/plane_alignment.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "services/target-locator/plane/plane_kernel.hpp"
#include "services/target-locator/plane/plane_template.hpp"

namespace markservo::target_locator {
namespace {

// Parameters of right(u - disparity) = gain left + offset + rising d left / dv: disparity at the centre, along u, along
// v (both per half extent of the mark), gain, offset, and how much higher the right view lies than the rows say.
using Vector6 = Eigen::Matrix<double, kPlaneParameters, 1>;
using Matrix6 = Eigen::Matrix<double, kPlaneParameters, kPlaneParameters>;

struct NormalMatrices {
  Matrix6 newton = Matrix6::Zero();       // derivative of the normal equations
  Matrix6 information = Matrix6::Zero();  // of their noise, times the residuals' variance
  double count = 0.0;
};

NormalMatrices normal_matrices(const PlaneTemplate& t) {
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

struct Residuals {
  Vector6 right_side = Vector6::Zero();
  double sum_of_squares = 0.0;
};

Residuals residuals(const PlaneTemplate& t, const std::vector<float>& warped, const Vector6& p,
                    std::vector<float>& residual) {
  residual.resize(t.padded());
  const ResidualSums sums = sum_residuals(t, warped.data(), static_cast<float>(p[3]), static_cast<float>(p[4]),
                                          static_cast<float>(p[5]), residual.data());
  return {Vector6::Map(sums.products.data()), sums.squares};
}

// Standard deviation of what is no outlier.
double robust_sigma(const PlaneTemplate& t, const std::vector<float>& residual) {
  constexpr double kMeanOfNormal = 0.7979;  // of |x| for sigma 1
  constexpr double kCut = 2.5;
  constexpr double kMeanOfCutNormal = 0.7724;  // for |x| up to kCut
  const double all = mean_absolute(t, residual.data(), std::numeric_limits<float>::max()).mean / kMeanOfNormal;
  return mean_absolute(t, residual.data(), static_cast<float>(kCut * all)).mean / kMeanOfCutNormal;
}

Vector6 parameters_of(const DisparityPlane& plane, const PlaneTemplate& t) {
  Vector6 p;
  p << plane.at(t.u0, t.v0), plane.along_u * t.extent, plane.along_v * t.extent, 1.0, 0.0, 0.0;
  return p;
}

DisparityPlane plane_of(const Vector6& p, const PlaneTemplate& t) {
  return {t.u0, t.v0, p[0], p[1] / t.extent, p[2] / t.extent};
}

// Gauss-Newton over one set of pixels.
class Fit {
 public:
  // Works on `pixels`, one of the two of `templates`.
  Fit(const StereoPatch& patch, PlaneTemplates& templates, PlaneTemplate& pixels)
      : patch_(patch), pixels_(pixels), warped_(templates.warped), residual_(templates.residual) {
    factorise();
  }

  const PlaneTemplate& pixels() const { return pixels_; }
  const Vector6& parameters() const { return p_; }
  bool solvable() const { return solvable_; }

  // From `start` until a step moves the disparities by less than `settled`; residuals are those before the last step.
  // False when it diverges.
  bool iterate(const Vector6& start, int iterations, double settled, double max_change) {
    p_ = start;
    for (int k = 0; k < iterations; ++k) {
      evaluate();
      const Vector6 change = -solver_.solve(sums_.right_side);
      if (!change.allFinite()) return false;
      p_ += change;
      if (!((p_ - start).head<3>().cwiseAbs().sum() < 3.0 * max_change)) return false;
      // Residuals of a step that changes the light say nothing.
      constexpr double kSettledOffset = 0.5;  // grey levels
      if (change.head<3>().cwiseAbs().sum() < settled && std::abs(change[4]) < kSettledOffset) break;
    }
    return true;
  }

  // Leaves out the pixels with large residuals; returns the share that stays.
  double drop_outliers(double sigmas) {
    const double limit = std::max(2.0, sigmas * robust_sigma(pixels_, residual_));
    const std::size_t kept = drop_above(residual_.data(), static_cast<float>(limit), pixels_);
    if (kept < pixels_.size()) factorise();
    return static_cast<double>(kept) / static_cast<double>(pixels_.size());
  }

  double correlation() const { return correlation_of(pixels_, warped_); }

  std::optional<Matrix6> covariance(double noise_correlation) const {
    const double variance = noise_correlation * sums_.sum_of_squares / std::max(1.0, normal_.count - kPlaneParameters);
    const Matrix6 inverse = solver_.inverse();
    const Matrix6 covariance = variance * inverse * normal_.information * inverse.transpose();
    if (!covariance.allFinite()) return std::nullopt;
    return covariance;
  }

 private:
  void factorise() {
    normal_ = normal_matrices(pixels_);
    solvable_ = normal_.count >= 3.0 * kPlaneParameters;
    solver_.compute(normal_.newton);
  }
  void evaluate() {
    warp(patch_, pixels_, plane_of(p_, pixels_), warped_);
    sums_ = residuals(pixels_, warped_, p_, residual_);
  }

  const StereoPatch& patch_;
  PlaneTemplate& pixels_;
  NormalMatrices normal_;
  Eigen::PartialPivLU<Matrix6> solver_;
  bool solvable_ = false;
  Vector6 p_ = Vector6::Zero();
  std::vector<float>& warped_;
  std::vector<float>& residual_;
  Residuals sums_;
};

}  // namespace

void make_templates(const StereoPatch& patch, const Mask& mask, const AlignmentParameters& parameters,
                    PlaneTemplates& pixels) {
  make_template(patch, mask, parameters.max_rough_pixels, pixels.rough);
  make_template(patch, mask, parameters.max_pixels, pixels.all);
}

std::optional<PlaneAlignment> align_plane(const StereoPatch& patch, const Mask& mask, const DisparityPlane& seed,
                                          const AlignmentParameters& parameters) {
  PlaneTemplates pixels;
  make_templates(patch, mask, parameters, pixels);
  return align_plane(patch, pixels, seed, parameters);
}

std::optional<PlaneAlignment> align_plane(const StereoPatch& patch, PlaneTemplates& pixels, const DisparityPlane& seed,
                                          const AlignmentParameters& parameters) {
  if (patch.right_rows.width < 4) return std::nullopt;
  Fit rough(patch, pixels, pixels.rough);
  if (!rough.solvable()) return std::nullopt;
  const Vector6 start = parameters_of(seed, rough.pixels());
  if (!rough.iterate(start, parameters.max_iterations, parameters.rough_px, parameters.max_seed_error_px)) {
    return std::nullopt;
  }
  Fit fit(patch, pixels, pixels.all);
  Vector6 close = parameters_of(plane_of(rough.parameters(), rough.pixels()), fit.pixels());
  close.tail<3>() = rough.parameters().tail<3>();
  close[4] += close[3] * (fit.pixels().mean_grey - rough.pixels().mean_grey);
  const auto iterate = [&](const Vector6& from) {
    return fit.iterate(from, parameters.max_final_iterations, parameters.settled_px, parameters.max_seed_error_px);
  };
  if (!fit.solvable() || !iterate(close)) return std::nullopt;
  const double share = fit.drop_outliers(parameters.outlier_sigmas);
  constexpr double kHardlyAny = 0.995;  // noise alone exceeds 3.5 sigmas now and then
  if (share < kHardlyAny && (!fit.solvable() || !iterate(fit.parameters()))) return std::nullopt;
  const auto covariance = fit.covariance(parameters.noise_correlation);
  if (!covariance) return std::nullopt;

  PlaneAlignment result;
  result.plane = plane_of(fit.parameters(), fit.pixels());
  if (std::abs(result.plane.at_centre - seed.at(result.plane.u0, result.plane.v0)) > parameters.max_seed_error_px) {
    return std::nullopt;
  }
  const double extent = fit.pixels().extent;
  const Eigen::DiagonalMatrix<double, 3> unit(1.0, 1.0 / extent, 1.0 / extent);
  result.covariance = unit * covariance->topLeftCorner<3, 3>() * unit;
  result.covariance(0, 0) += parameters.disparity_floor_px * parameters.disparity_floor_px;
  result.row_offset = -fit.parameters()[5];
  result.correlation = fit.correlation();
  result.inlier_share = share;
  return result;
}

}  // namespace markservo::target_locator
