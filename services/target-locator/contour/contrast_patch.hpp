#pragma once

// Both views of a mark in the colour by which it stands out from its surroundings.

#include <optional>

#include "services/target-locator/image/mark_images.hpp"
#include "services/target-locator/image/stereo_patch.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

// As make_mark_images' patch, but on the left view's contrast in grey levels, so that the outline shows and not the
// texture. Nothing where mark and surroundings look the same.
std::optional<StereoPatch> contrast_patch(const MarkObservation& observation, const MarkImages& images);

}  // namespace markservo::target_locator
