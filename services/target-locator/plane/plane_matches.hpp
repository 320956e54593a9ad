#pragma once

// What the features of a mark say of the plane that all its texture was aligned to.

#include <vector>

#include "services/target-locator/features/features.hpp"
#include "services/target-locator/image/stereo_patch.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/matching/refinement.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"

namespace markservo::target_locator {

struct PlaneMatches {
  std::vector<Match> on_plane;
  // Of all features that were found: distance from the plane over its sigma, squared.
  std::vector<double> squared_scores;
};

// Each feature is matched for itself, from where the plane says it is and over the pixels of `inside`; it lies on the
// plane if its disparity is within `max_distance` (patch px).
PlaneMatches match_on_plane(const StereoPatch& patch, const std::vector<Feature>& features, const Mask& inside,
                            const PlaneAlignment& alignment, const RefinementParameters& parameters,
                            double max_distance);

// How far beyond chance the features lie off the plane: 1 when their own sigmas explain it.
double plane_misfit(std::vector<double> squared_scores);

}  // namespace markservo::target_locator
