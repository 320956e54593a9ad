#include "services/target-locator/plane/plane_alignment.hpp"

#include <cmath>
#include <limits>

#include "services/target-locator/image/epipolar_rows.hpp"
#include "services/target-locator/plane/plane_fit.hpp"

namespace markservo::target_locator {
namespace {

// Where the fit to all pixels begins: where that to few ended.
Vector6 restart(const PlaneFit& rough, const PlaneTemplate& pixels) {
  Vector6 close = parameters_of(plane_of(rough.parameters(), rough.pixels()), pixels);
  close.tail<3>() = rough.parameters().tail<3>();
  close[4] += close[3] * (pixels.mean_grey - rough.pixels().mean_grey);
  return close;
}

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
  PlaneFit rough(patch, pixels, pixels.rough);
  if (!rough.solvable()) return std::nullopt;
  const FitLimits roughly{parameters.max_iterations, parameters.rough_px, parameters.max_seed_error_px};
  if (!rough.iterate(parameters_of(seed, rough.pixels()), roughly)) return std::nullopt;
  PlaneFit fit(patch, pixels, pixels.all);
  FitLimits finely{parameters.max_final_iterations, parameters.settled_px, parameters.max_seed_error_px};
  if (!fit.solvable() || !fit.iterate(restart(rough, fit.pixels()), finely)) return std::nullopt;
  const double share = fit.drop_outliers(parameters.outlier_sigmas);
  constexpr double kHardlyAny = 0.995;  // noise alone exceeds 3.5 sigmas now and then
  if (share < kHardlyAny) {
    finely.max_change_px = std::numeric_limits<double>::infinity();  // the end is held against the seed below
    if (!fit.solvable() || !fit.iterate(fit.parameters(), finely)) return std::nullopt;
  }
  const auto covariance = fit.covariance(parameters.noise_correlation);
  if (!covariance) return std::nullopt;

  PlaneAlignment result;
  result.plane = plane_of(fit.parameters(), fit.pixels());
  if (std::abs(result.plane.at_centre - seed.at(result.plane.u0, result.plane.v0)) > parameters.max_seed_error_px) {
    return std::nullopt;
  }
  const double extent = fit.pixels().origin.extent;
  const Eigen::DiagonalMatrix<double, 3> unit(1.0, 1.0 / extent, 1.0 / extent);
  result.covariance = unit * covariance->topLeftCorner<3, 3>() * unit;
  result.covariance(0, 0) += parameters.disparity_floor_px * parameters.disparity_floor_px;
  result.row_offset = -fit.parameters()[5];
  result.correlation = fit.correlation();
  result.inlier_share = share;
  return result;
}

std::optional<PlaneAlignment> with_rows_aligned(StereoPatch& patch, const Mask& mask,
                                                const std::optional<PlaneAlignment>& first,
                                                const AlignmentLimits& limits, const AlignmentParameters& parameters) {
  if (!first || !(std::abs(first->row_offset) > limits.worth_resampling_px) ||
      !(std::abs(first->row_offset) <= limits.max_row_offset)) {
    return first;
  }
  const double offset = first->row_offset;
  align_rows(patch.right, patch.right_frame, patch.left_frame, patch.left.height, offset, patch.right_rows);
  auto alignment = align_plane(patch, mask, first->plane, parameters);
  if (alignment) alignment->row_offset += offset;
  return alignment;
}

bool is_known(const std::optional<PlaneAlignment>& alignment, const AlignmentLimits& limits) {
  return alignment && !(std::sqrt(alignment->covariance(0, 0)) > limits.max_centre_sigma);
}

bool is_one_mark(const PlaneAlignment& alignment, const AlignmentLimits& limits) {
  return !(alignment.correlation < limits.min_correlation) && !(std::abs(alignment.row_offset) > limits.max_row_offset);
}

}  // namespace markservo::target_locator
