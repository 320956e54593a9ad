#pragma once

// All of a flat mark's texture at once: the plane of disparities that makes the right view look like the left one.

#include <Eigen/Core>
#include <optional>

#include "services/target-locator/plane/plane_template.hpp"

namespace markservo::target_locator {

struct AlignmentParameters {
  int max_iterations = 10;       // on few pixels, until the change is below rough_px
  int max_final_iterations = 3;  // on all, until it is below settled_px
  double rough_px = 0.02;        // of disparity, at the mark's middle plus at its ends
  double settled_px = 0.004;
  int max_rough_pixels = 800;
  double max_seed_error_px = 3.0;     // from the coarse disparity; farther than that it ran away
  int max_pixels = 2000;              // larger masks are thinned out: neighbours repeat each other
  double outlier_sigmas = 3.5;        // pixels with larger residuals are hidden in one view, or shine
  double noise_correlation = 1.3;     // interpolation hides part of the right image's noise from the residuals
  double disparity_floor_px = 0.010;  // what interpolation and the lens model leave, whatever the texture
};

struct AlignmentLimits {
  double min_correlation = 0.5;      // of the views of one mark, on its plane
  double max_centre_sigma = 0.3;     // px of disparity: with less to tell by the depth is a guess
  double max_row_offset = 3.0;       // px: rows are epipolar lines
  double worth_resampling_px = 0.2;  // of row offset beyond which its linear model is poor
};

struct PlaneAlignment {
  DisparityPlane plane;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of (at_centre, along_u, along_v)
  double row_offset = 0.0;                               // px, what the right view lies lower than the rows say
  double correlation = 0.0;                              // of the two views' grey values on the plane, -1..1
  double inlier_share = 0.0;                             // of the pixels
};

// Makes the templates of the masked pixels; `pixels` keeps its memory.
void make_templates(const StereoPatch& patch, const Mask& mask, const AlignmentParameters& parameters,
                    PlaneTemplates& pixels);

// Least squares over the masked left pixels: disparity plane, gain and offset between the cameras, and a row offset as
// nuisance (plane_fit.hpp). Nothing when the texture does not fix the plane or the iteration leaves the seed's
// neighbourhood.
std::optional<PlaneAlignment> align_plane(const StereoPatch& patch, const Mask& mask, const DisparityPlane& seed,
                                          const AlignmentParameters& parameters);

// The same over pixels taken before; those that turn out to be outliers lose their weight.
std::optional<PlaneAlignment> align_plane(const StereoPatch& patch, PlaneTemplates& pixels, const DisparityPlane& seed,
                                          const AlignmentParameters& parameters);

// What `first` has found over the mask, or, where the rows turn out to lie off, once more with them where they lie.
std::optional<PlaneAlignment> with_rows_aligned(StereoPatch& patch, const Mask& mask,
                                                const std::optional<PlaneAlignment>& first,
                                                const AlignmentLimits& limits, const AlignmentParameters& parameters);

// There is an alignment, and it tells the depth.
bool is_known(const std::optional<PlaneAlignment>& alignment, const AlignmentLimits& limits);

// Its views show one thing.
bool is_one_mark(const PlaneAlignment& alignment, const AlignmentLimits& limits);

}  // namespace markservo::target_locator
