#pragma once

// The centre of a flat mark from all that both images show of it.

#include <optional>

#include "services/target-locator/centre/centre_fusion.hpp"
#include "services/target-locator/centre/seen_centre.hpp"
#include "services/target-locator/hidden/hidden_sides_parameters.hpp"
#include "services/target-locator/image/mark_images.hpp"
#include "services/target-locator/image/mask_refinement.hpp"
#include "services/target-locator/plane/mark_plane.hpp"

namespace markservo::target_locator {

struct CentreParameters {
  SeenCentreParameters seen;
  double one_view_print_doubt = 1.32;        // as seen.print_doubt, where one view alone is used
  MaskRefinementParameters mask_refinement;  // for marks of which something is hidden
  HiddenSidesParameters hidden_sides;
};

// The middle of the square on its plane, which must be measured. Where both views show all of it in the same place, the
// left outline; where something hides a part of a square of known size, from the sides that are left; else from what
// each view shows. Nothing when the mark is not in front of the cameras. `contrast` is room.
std::optional<CentreEstimate> flat_mark_centre(const MarkObservation& observation, const MarkPlane& plane,
                                               const geometry::StereoCamera& camera, const CentreParameters& parameters,
                                               MarkImages& images, PlaneImage& contrast);

}  // namespace markservo::target_locator
