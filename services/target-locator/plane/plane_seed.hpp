#pragma once

// Where a plane's alignment begins: the disparity plane to a pixel or so.

#include <optional>

#include "services/target-locator/plane/plane_alignment.hpp"

namespace markservo::target_locator {

struct SeedParameters {
  double plain = 0.9;  // correlation of the guess itself that leaves nothing to search for
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

// Coarse: the whole-pixel shift about `guess` that correlates the rough template's pixels best, within `reach` px
// either way.
PlaneSeed seed_plane(const StereoPatch& patch, PlaneTemplates& pixels, const DisparityPlane& guess, double reach,
                     const SeedParameters& parameters);

}  // namespace markservo::target_locator
