#pragma once

// A mark that is no plane: each feature is matched for itself, and the mark is where they are.

#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/features/features.hpp"
#include "services/target-locator/free_surface/patch_matching.hpp"
#include "services/target-locator/image/stereo_patch.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/mark_observation.hpp"
#include "services/target-locator/matching/refinement.hpp"

namespace markservo::target_locator {

struct FreeSurfaceParameters {
  SearchParameters search;  // its disparities are replaced by the boxes' where min >= max
  RefinementParameters refinement = {5, true, 8, 0.005, 0.7, 0.85};
};

// Locates the mark where at least `min_matches` features are matched.
Location locate_free_surface(const MarkObservation& observation, const geometry::StereoCamera& camera,
                             const FreeSurfaceParameters& parameters, int min_matches, const StereoPatch& patch,
                             const std::vector<Feature>& features);

}  // namespace markservo::target_locator
