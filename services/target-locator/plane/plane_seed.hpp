#pragma once

// Where a plane's alignment begins: the disparity plane to a pixel or so.

#include <optional>

#include "services/target-locator/image/mark_images.hpp"
#include "services/target-locator/mark_observation.hpp"
#include "services/target-locator/plane/disparity_plane.hpp"
#include "services/target-locator/plane/plane_template.hpp"

namespace markservo::target_locator {

struct SeedParameters {
  double plain = 0.9;          // correlation of the guess itself that leaves nothing to search for
  double alike = 0.8;          // correlation near the masks' plane that needs no further search
  double near_px = 2.0;        // either way of the masks' plane
  double reach = 0.25;         // either way of what the boxes say, of their width
  double largest_slope = 0.4;  // px of disparity per px that boxes are believed about
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

// Where the alignment of a mark begins, over the pixels of the rough template. The masks tell the plane to a pixel or
// so unless one of them is partly hidden; then the boxes and a wide search do.
PlaneSeed find_seed(const MarkObservation& observation, const MarkImages& images, PlaneTemplates& pixels,
                    const SeedParameters& parameters);

}  // namespace markservo::target_locator
