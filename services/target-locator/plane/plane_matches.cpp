#include "services/target-locator/plane/plane_matches.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace markservo::target_locator {

PlaneMatches match_on_plane(const StereoPatch& patch, const std::vector<Feature>& features, const Mask& inside,
                            const PlaneAlignment& alignment, const RefinementParameters& parameters,
                            double max_distance) {
  const DisparityPlane& plane = alignment.plane;
  PlaneMatches matches;
  matches.squared_scores.reserve(features.size());
  matches.on_plane.reserve(features.size());
  for (const Feature& feature : features) {
    const double u = patch.left_frame.u_of(feature.column);
    const double v = patch.left_frame.v_of(feature.row);
    const double on_plane = plane.at(u, v);
    const auto match = refine_match(patch, feature, {on_plane, plane.along_u, plane.along_v}, &inside, parameters);
    if (!match) continue;
    const double residual = std::abs(match->local.disparity - on_plane);
    matches.squared_scores.push_back(residual * residual / std::max(1e-6, match->sigma * match->sigma));
    if (residual > max_distance * patch.left_frame.scale) continue;
    matches.on_plane.push_back({u, v, u - match->local.disparity, v + alignment.row_offset, residual});
  }
  return matches;
}

double plane_misfit(std::vector<double> squared_scores) {
  if (squared_scores.empty()) return 1.0;
  const auto middle = squared_scores.begin() + static_cast<std::ptrdiff_t>(squared_scores.size() / 2);
  std::nth_element(squared_scores.begin(), middle, squared_scores.end());
  constexpr double kMedianOfChiSquare = 0.455;
  // Below 4 the features' own sigmas may simply be a little small.
  return std::max(1.0, *middle / kMedianOfChiSquare / 4.0);
}

}  // namespace markservo::target_locator
