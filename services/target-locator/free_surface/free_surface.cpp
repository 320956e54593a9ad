#include "services/target-locator/free_surface/free_surface.hpp"

#include <algorithm>

#include "services/target-locator/free_surface/point_cloud_centre.hpp"

namespace markservo::target_locator {
namespace {

// Disparities that what the boxes show can have.
void search_within_boxes(const View& left, const View& right, const geometry::StereoCamera& camera,
                         SearchParameters& search) {
  constexpr double kLeast = 1.0;  // px beyond that of a point at infinity
  const double middle = left.centre_u() - right.centre_u();
  const double reach = 0.5 * std::max(left.width, right.width);
  search.disparity_min = std::max(middle - reach, camera.cx_left - camera.cx_right + kLeast);
  search.disparity_max = middle + reach;
}

}  // namespace

Location locate_free_surface(const MarkObservation& observation, const geometry::StereoCamera& camera,
                             const FreeSurfaceParameters& parameters, int min_matches, const StereoPatch& patch,
                             const std::vector<Feature>& features) {
  Location location;
  SearchParameters search = parameters.search;
  if (!(search.disparity_min < search.disparity_max)) {
    search_within_boxes(observation.left, observation.right, camera, search);
  }
  for (const Feature& feature : features) {
    const auto rough = search_match(patch, feature, search);
    if (!rough) continue;
    const auto match = refine_match(patch, feature, {*rough, 0.0, 0.0}, nullptr, parameters.refinement);
    if (!match) continue;
    const double u = patch.left_frame.u_of(feature.column);
    const double v = patch.left_frame.v_of(feature.row);
    location.matches.push_back({u, v, u - match->local.disparity, v, match->sigma});
  }
  const auto centre = centre_of_points(location.matches, camera);
  location.status = Status::kTooFewMatches;
  if (!centre || static_cast<int>(location.matches.size()) < min_matches) return location;
  location.status = Status::kLocated;
  location.cue = Cue::kTexture;
  location.p_C = centre->p_C;
  location.covariance = centre->covariance;
  return location;
}

}  // namespace markservo::target_locator
