#pragma once

// The place of a mark by the middle of its colour in both views: what is left when neither texture nor outline tell.

#include <optional>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/contour/outline_views.hpp"
#include "services/target-locator/contour/shared_outline.hpp"
#include "services/target-locator/image/mark_images.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

struct ColourCentroidParameters {
  double floor_px = 0.05;        // patch px, of a centroid whatever the noise
  double unknown_missing = 0.1;  // relative: what may be missing of a mark whose size or shape is not known
  double most_missing = 0.3;     // relative, beyond it something hides too much of the mark
};

// Measures a mark by the middle of its colour. An affine map takes middles to middles, so that the two belong together
// whatever the shape. What may be missing of the mark in one view is in the covariance. `views` are of `images`.
// Nothing where too much is missing.
std::optional<OutlineEstimate> locate_by_centroid(const MarkObservation& observation,
                                                  const geometry::StereoCamera& camera,
                                                  const ColourCentroidParameters& parameters, const MarkImages& images,
                                                  const ContrastViews& views);

}  // namespace markservo::target_locator
