#pragma once

// All of a flat mark's texture at once: the plane of disparities that makes the right view look like the left one.

#include <Eigen/Core>
#include <optional>

#include "services/target-locator/plane_image.hpp"
#include "services/target-locator/structure_tensor.hpp"

namespace markservo::target_locator {

// Disparity u_left - u_right (image px) over the left image. A plane in space has exactly this form.
struct DisparityPlane {
  double u0 = 0.0;         // px, left image: where `at_centre` holds
  double v0 = 0.0;         // px
  double at_centre = 0.0;  // px
  double along_u = 0.0;    // px per px
  double along_v = 0.0;    // px per px

  double at(double u, double v) const { return at_centre + along_u * (u - u0) + along_v * (v - v0); }
};

// The two views of one mark as grey planes.
struct StereoPatch {
  PlaneImage left;
  PatchFrame left_frame;
  Gradients left_gradients;
  PlaneImage right;       // as cut
  PlaneImage right_rows;  // aligned to the left patch's rows
  PatchFrame right_frame;
};

struct AlignmentParameters {
  int max_iterations = 10;       // on few pixels, until the change is below rough_px
  int max_final_iterations = 3;  // on all, until it is below settled_px
  double rough_px = 0.02;        // of disparity, at the mark's middle plus at its ends
  double settled_px = 0.001;
  int max_rough_pixels = 800;
  double max_seed_error_px = 3.0;     // from the coarse disparity; farther than that it ran away
  int max_pixels = 2000;              // larger masks are thinned out: neighbours repeat each other
  int max_seed_pixels = 250;          // for the coarse search
  double outlier_sigmas = 3.5;        // pixels with larger residuals are hidden in one view, or shine
  double noise_correlation = 1.3;     // interpolation hides part of the right image's noise from the residuals
  double disparity_floor_px = 0.008;  // what interpolation and the lens model leave, whatever the texture
};

struct PlaneAlignment {
  DisparityPlane plane;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of (at_centre, along_u, along_v)
  double row_offset = 0.0;                               // px, what the right view lies lower than the rows say
  double correlation = 0.0;                              // of the two views' grey values on the plane, -1..1
  double inlier_share = 0.0;                             // of the pixels
};

// A disparity plane to start from, and how well the views correlate on it.
struct PlaneSeed {
  DisparityPlane plane;
  double correlation = -1.0;
};

// The plane that maps the left mask's first and second moments to the right mask's: a plane in space maps the one to
// the other by an affine map along the rows. Nothing when a mask is empty or a line, or the map is steeper than can be
// seen.
std::optional<DisparityPlane> plane_of_masks(const Mask& left, const PatchFrame& left_frame, const Mask& right,
                                             const PatchFrame& right_frame);

// Coarse: the whole-pixel shift about `guess` that correlates the masked pixels best, within `reach` px either way.
PlaneSeed seed_plane(const StereoPatch& patch, const Mask& mask, const DisparityPlane& guess, double reach,
                     const AlignmentParameters& parameters);

// Least squares over the masked left pixels: disparity plane, gain and offset between the cameras, and a row offset as
// nuisance. Nothing when the texture does not fix the plane or the iteration leaves the seed's neighbourhood.
std::optional<PlaneAlignment> align_plane(const StereoPatch& patch, const Mask& mask, const DisparityPlane& seed,
                                          const AlignmentParameters& parameters);

}  // namespace markservo::target_locator
