#include "services/target-locator/plane/mark_plane.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "services/target-locator/plane/plane_matches.hpp"
#include "services/target-locator/plane/shared_visibility.hpp"

namespace markservo::target_locator {
namespace {

// What the alignment itself says of the plane.
Status status_of(const std::optional<PlaneAlignment>& alignment, const AlignmentLimits& limits) {
  if (!is_known(alignment, limits)) return Status::kTooFewMatches;
  return is_one_mark(*alignment, limits) ? Status::kLocated : Status::kInconsistent;
}

// What the features say of it.
Status status_of(const PlaneMatches& matches, std::size_t num_features, int min_matches, double min_agreeing) {
  const auto found = static_cast<int>(matches.on_plane.size());
  if (found < min_matches) {
    const bool contradict = static_cast<int>(matches.squared_scores.size()) >= 2 * min_matches;
    return contradict ? Status::kInconsistent : Status::kTooFewMatches;
  }
  return found < min_agreeing * static_cast<double>(num_features) ? Status::kInconsistent : Status::kLocated;
}

}  // namespace

MarkPlane measure_plane(const MarkObservation& observation, const PlaneParameters& parameters, int min_matches,
                        MarkImages& images, std::vector<Feature>& features, PlaneWorkspace& work) {
  MarkPlane measured;
  if (static_cast<int>(features.size()) < min_matches) return measured;
  StereoPatch& patch = images.patch;
  const Mask* inside = &images.left.inner;
  make_template(patch, *inside, parameters.alignment.max_rough_pixels, work.pixels.rough);
  const PlaneSeed seed = find_seed(observation, images, work.pixels, parameters.seed);
  seen_by_both(*inside, patch.left_frame, images.right.inner, patch.right_frame, seed.plane, work.common);
  const bool all_in_common =
      static_cast<double>(work.common.count()) >= parameters.whole_share * static_cast<double>(inside->count());
  if (!all_in_common) {
    inside = &work.common;
    keep_within(*inside, features);
    make_template(patch, *inside, parameters.alignment.max_rough_pixels, work.pixels.rough);
  }
  make_template(patch, *inside, parameters.alignment.max_pixels, work.pixels.all);
  const auto first = align_plane(patch, work.pixels, seed.plane, parameters.alignment);
  const auto alignment = with_rows_aligned(patch, *inside, first, parameters.limits, parameters.alignment);
  measured.status = status_of(alignment, parameters.limits);
  if (measured.status != Status::kLocated) return measured;

  measured.alignment = *alignment;
  PlaneMatches matches =
      match_on_plane(patch, features, *inside, *alignment, parameters.verification, parameters.max_plane_distance);
  measured.status = status_of(matches, features.size(), min_matches, parameters.min_agreeing);
  measured.alignment.covariance *= plane_misfit(std::move(matches.squared_scores));
  measured.matches = std::move(matches.on_plane);
  const DisparityPlane& plane = alignment->plane;
  const double apart = std::abs(seed.plane.at(plane.u0, plane.v0) - plane.at_centre);  // masks and print
  measured.views_alike = all_in_common && apart <= parameters.masks_agree_px;
  return measured;
}

}  // namespace markservo::target_locator
