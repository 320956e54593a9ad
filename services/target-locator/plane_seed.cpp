#include "services/target-locator/plane_seed.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "services/target-locator/plane_template.hpp"

namespace markservo::target_locator {
namespace {

// Of the masked pixels, in the image: count, centroid (px) and second moments about it (px^2).
struct MaskMoments {
  double count = 0.0;
  double u = 0.0;
  double v = 0.0;
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
};

MaskMoments moments_of(const Mask& mask, const PatchFrame& frame) {
  MaskMoments m;
  // About the mask's middle, so that sums stay small.
  const double middle_x = 0.5 * mask.width();
  const double middle_y = 0.5 * mask.height();
  for (int y = 0; y < mask.height(); ++y) {
    if (mask.surely_empty(y)) continue;
    const double dy = y - middle_y;
    for (int begin = mask.next(y, 0, true); begin < mask.width();) {
      const int end = mask.next(y, begin, false);
      const double n = end - begin;
      const double dx = 0.5 * (begin + end - 1) - middle_x;
      m.count += n;
      m.u += n * dx;
      m.v += n * dy;
      m.uu += n * (dx * dx + (n * n - 1.0) / 12.0);
      m.uv += n * dx * dy;
      m.vv += n * dy * dy;
      begin = mask.next(y, end, true);
    }
  }
  if (!(m.count > 0.0)) return m;
  const double u = m.u / m.count;
  const double v = m.v / m.count;
  const double unit = frame.scale * frame.scale;
  m.uu = unit * (m.uu / m.count - u * u);
  m.uv = unit * (m.uv / m.count - u * v);
  m.vv = unit * (m.vv / m.count - v * v);
  m.u = frame.u_of(middle_x + u);
  m.v = frame.v_of(middle_y + v);
  return m;
}

}  // namespace

std::optional<DisparityPlane> plane_of_masks(const Mask& left, const PatchFrame& left_frame, const Mask& right,
                                             const PatchFrame& right_frame) {
  const MaskMoments l = moments_of(left, left_frame);
  const MaskMoments r = moments_of(right, right_frame);
  if (!(l.count > 8.0) || !(r.count > 8.0) || !(l.vv > 0.5)) return std::nullopt;
  // u_right = (1 - along_u) u - along_v v + constant, v_right = v.
  const double left_width = l.uu - l.uv * l.uv / l.vv;
  const double right_width = r.uu - r.uv * r.uv / l.vv;
  if (!(left_width > 0.5) || !(right_width > 0.5)) return std::nullopt;
  const double stretch = std::sqrt(right_width / left_width);
  DisparityPlane plane;
  plane.u0 = l.u;
  plane.v0 = l.v;
  plane.at_centre = l.u - r.u;
  plane.along_u = 1.0 - stretch;
  plane.along_v = (stretch * l.uv - r.uv) / l.vv;
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

}  // namespace markservo::target_locator
