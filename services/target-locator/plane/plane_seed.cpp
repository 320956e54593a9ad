#include "services/target-locator/plane/plane_seed.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "services/target-locator/image/mask_moments.hpp"

namespace markservo::target_locator {
namespace {

DisparityPlane plane_of_boxes(const View& left, const View& right, double largest_slope) {
  DisparityPlane plane;
  plane.u0 = left.centre_u();
  plane.v0 = left.centre_v();
  plane.at_centre = left.centre_u() - right.centre_u();
  plane.along_u = std::clamp(1.0 - right.width / left.width, -largest_slope, largest_slope);
  return plane;
}

}  // namespace

std::optional<DisparityPlane> plane_of_masks(const Mask& left, const PatchFrame& left_frame, const Mask& right,
                                             const PatchFrame& right_frame) {
  const MaskMoments l = moments_of(left);
  const MaskMoments r = moments_of(right);
  if (!(l.n > 8.0) || !(r.n > 8.0) || !(l.yy > 0.5)) return std::nullopt;
  // In image px, of the left view and of the right one.
  const double left_unit = left_frame.scale * left_frame.scale;
  const double right_unit = right_frame.scale * right_frame.scale;
  const double vv = left_unit * l.yy;
  const double left_uv = left_unit * l.xy;
  const double right_uv = right_unit * r.xy;
  // u_right = (1 - along_u) u - along_v v + constant, v_right = v.
  const double left_width = left_unit * l.xx - left_uv * left_uv / vv;
  const double right_width = right_unit * r.xx - right_uv * right_uv / vv;
  if (!(left_width > 0.5) || !(right_width > 0.5)) return std::nullopt;
  const double stretch = std::sqrt(right_width / left_width);
  DisparityPlane plane;
  plane.u0 = left_frame.u_of(l.centre.x());
  plane.v0 = left_frame.v_of(l.centre.y());
  plane.at_centre = plane.u0 - right_frame.u_of(r.centre.x());
  plane.along_u = 1.0 - stretch;
  plane.along_v = (stretch * left_uv - right_uv) / vv;
  constexpr double kSteepest = 1.0;  // px per px
  if (!(std::abs(plane.along_u) < kSteepest) || !(std::abs(plane.along_v) < kSteepest)) return std::nullopt;
  return plane;
}

PlaneSeed seed_plane(const StereoPatch& patch, PlaneTemplates& pixels, const DisparityPlane& guess, double reach,
                     const SeedParameters& parameters) {
  const PlaneTemplate& t = pixels.rough;
  if (t.size() < 2 || patch.right_rows.width < 4) return {guess, -1.0};
  const double step = patch.right_frame.scale;
  // Shifted by more than its width the right view shows nothing; a box can say anything.
  const double far = static_cast<double>(patch.right_rows.width);
  const int steps = static_cast<int>(std::ceil(std::min(far, std::max(0.0, reach / step))));
  std::vector<float>& warped = pixels.warped;
  double best = -2.0;
  double best_shift = 0.0;
  // From the middle outwards, so that of equals the one nearest the guess wins.
  for (int k = 0; k <= 2 * steps; ++k) {
    const double shift = step * ((k % 2 == 0) ? k / 2 : -(k + 1) / 2);
    DisparityPlane shifted = guess;
    shifted.at_centre += shift;
    warp(patch, t, shifted, warped);
    const double score = correlation_of(t, warped);
    if (score > best) {
      best = score;
      best_shift = shift;
    }
    if (k == 0 && best >= parameters.plain) break;
  }
  PlaneSeed seed{guess, best};
  seed.plane.at_centre += best_shift;
  return seed;
}

PlaneSeed find_seed(const MarkObservation& observation, const MarkImages& images, PlaneTemplates& pixels,
                    const SeedParameters& parameters) {
  const StereoPatch& patch = images.patch;
  PlaneSeed best;
  const auto of_masks = plane_of_masks(images.left.mask, patch.left_frame, images.right.mask, patch.right_frame);
  if (of_masks) best = seed_plane(patch, pixels, *of_masks, parameters.near_px, parameters);
  if (best.correlation >= parameters.alike) return best;
  const double reach = parameters.reach * std::max(observation.left.width, observation.right.width);
  const auto consider = [&](const DisparityPlane& guess) {
    const PlaneSeed seed = seed_plane(patch, pixels, guess, reach, parameters);
    if (seed.correlation > best.correlation) best = seed;
  };
  if (of_masks) consider(*of_masks);
  const DisparityPlane of_boxes = plane_of_boxes(observation.left, observation.right, parameters.largest_slope);
  consider(of_boxes);
  // What hides one view more than the other makes slopes of its own.
  consider({of_boxes.u0, of_boxes.v0, of_boxes.at_centre, 0.0, 0.0});
  return best;
}

}  // namespace markservo::target_locator
