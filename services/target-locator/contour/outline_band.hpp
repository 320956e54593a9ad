#pragma once

// The plane of a mark of any shape by what both views show about its outline.

#include <optional>

#include "services/target-locator/image/mark_images.hpp"
#include "services/target-locator/mark_observation.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"
#include "services/target-locator/plane/plane_seed.hpp"

namespace markservo::target_locator {

struct OutlineBandParameters {
  int half_width = 3;              // patch px on either side of the outline: the blur's reach
  AlignmentLimits limits = {0.8};  // the outlines of one mark are more alike than its textures
  AlignmentParameters alignment;
};

// Matches the contour's points along the rows, all at once: the pixels about the outline are aligned as a texture is,
// in the colour by which the mark stands out. What lies behind the mark should be of one colour or as far away. Nothing
// when the views do not show the same outline.
std::optional<PlaneAlignment> plane_of_outline(const MarkObservation& observation, const MarkImages& images,
                                               const OutlineBandParameters& parameters);

}  // namespace markservo::target_locator
