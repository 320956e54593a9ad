#pragma once

// The place of a mark by its outline in both views: what carries it where there is no texture.

#include <optional>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/contour/outline_band.hpp"
#include "services/target-locator/contour/outline_views.hpp"
#include "services/target-locator/contour/shared_outline.hpp"
#include "services/target-locator/image/mark_images.hpp"
#include "services/target-locator/mark_observation.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"

namespace markservo::target_locator {

struct OutlineMethodParameters {
  OutlineViewParameters views;
  SharedOutlineParameters shared;
  OutlineBandParameters band;
};

// Measures a mark by its outline in both views. `texture` is what the texture says of the plane, to be fused with by
// its covariance, `views` are of `images`. Nothing when the outline is not what the mark is said to have, is hidden in
// part, or the views contradict each other.
std::optional<OutlineEstimate> locate_by_outline(const MarkObservation& observation,
                                                 const geometry::StereoCamera& camera,
                                                 const OutlineMethodParameters& parameters,
                                                 const std::optional<PlaneAlignment>& texture, const MarkImages& images,
                                                 const ContrastViews& views);

}  // namespace markservo::target_locator
