#include "services/target-locator/plane/mark_plane.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "services/target-locator/image/epipolar_rows.hpp"
#include "services/target-locator/plane/plane_matches.hpp"
#include "services/target-locator/plane/shared_visibility.hpp"

namespace markservo::target_locator {
namespace {

// Over the templates' pixels, and once more with the rows where they turn out to lie.
std::optional<PlaneAlignment> align(StereoPatch& patch, const Mask& inside, const DisparityPlane& seed,
                                    const PlaneParameters& parameters, PlaneTemplates& pixels) {
  auto alignment = align_plane(patch, pixels, seed, parameters.alignment);
  if (!alignment || !(std::abs(alignment->row_offset) > parameters.worth_resampling_px) ||
      !(std::abs(alignment->row_offset) <= parameters.max_row_offset)) {
    return alignment;
  }
  const double offset = alignment->row_offset;
  align_rows(patch.right, patch.right_frame, patch.left_frame, patch.left.height, offset, patch.right_rows);
  alignment = align_plane(patch, inside, alignment->plane, parameters.alignment);
  if (alignment) alignment->row_offset += offset;
  return alignment;
}

// What the alignment itself says of the plane.
Status status_of(const std::optional<PlaneAlignment>& alignment, const PlaneParameters& parameters) {
  if (!alignment || std::sqrt(alignment->covariance(0, 0)) > parameters.max_centre_sigma) {
    return Status::kTooFewMatches;
  }
  const bool one_mark = !(alignment->correlation < parameters.min_correlation) &&
                        !(std::abs(alignment->row_offset) > parameters.max_row_offset);
  return one_mark ? Status::kLocated : Status::kInconsistent;
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
  const auto alignment = align(patch, *inside, seed.plane, parameters, work.pixels);
  measured.status = status_of(alignment, parameters);
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
