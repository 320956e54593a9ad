#pragma once

// The paper's way from features to a place (sections 3.1 and 3.2), on the same images, for comparison.

#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/features/features.hpp"
#include "services/target-locator/image/stereo_patch.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/mark_observation.hpp"
#include "services/target-locator/paper/paper_matching.hpp"

namespace markservo::target_locator {

// Located where at least `min_matches` features have a partner in front of the cameras.
Location locate_as_in_the_paper(const MarkObservation& observation, const geometry::StereoCamera& camera,
                                const PaperParameters& parameters, int min_matches, const StereoPatch& patch,
                                const std::vector<Feature>& features);

}  // namespace markservo::target_locator
