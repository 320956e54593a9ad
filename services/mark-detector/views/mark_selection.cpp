#include "services/mark-detector/views/mark_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace markservo::mark_detector {
namespace {

double ratio(double a, double b) {
  return std::max(a, b) / std::max(1.0, std::min(a, b));
}

// The blob of one image alone: nearest to (u, v), or the largest.
std::size_t select_single(const std::vector<Blob>& blobs, const std::optional<PairPlace>& last, bool is_left) {
  if (!last) return 0;
  const double u = is_left ? last->u_left : last->u_right;
  const auto distance = [&](const Blob& blob) { return std::hypot(blob.shape.u - u, blob.shape.v - last->v_left); };
  const auto nearest = std::min_element(blobs.begin(), blobs.end(),
                                        [&](const Blob& a, const Blob& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - blobs.begin());
}

// What says that two shapes cannot be one mark.
enum class Contradiction { kNone, kRows, kDisparity, kHeights, kAreas, kSize };

// The numbers that a pair is judged by.
struct Judgement {
  Contradiction contradiction = Contradiction::kNone;
  double rows = 0.0;  // px apart
  double rows_allowed = 0.0;
  double disparity = 0.0;      // px
  double area = 0.0;           // px, mean
  double expected_area = 0.0;  // px
};

Judgement judge(const Shape& left, const Shape& right, const SelectionContext& context,
                const SelectionParameters& parameters) {
  Judgement j;
  const auto contradicted = [&j](Contradiction by) {
    j.contradiction = by;
    return j;
  };
  j.rows = std::abs(left.v - right.v);
  j.rows_allowed = parameters.row_tolerance + parameters.row_tolerance_of_height * std::max(left.height, right.height);
  if (j.rows > j.rows_allowed) return contradicted(Contradiction::kRows);
  j.disparity = left.u - right.u - context.principal_offset;
  if (j.disparity <= 0.0) return contradicted(Contradiction::kDisparity);
  // What the border cuts off is not the same in both images.
  if (is_clipped(left, context.image_width, context.image_height) ||
      is_clipped(right, context.image_width, context.image_height)) {
    return j;
  }
  if (ratio(left.height, right.height) > parameters.height_ratio_max) return contradicted(Contradiction::kHeights);
  if (ratio(left.area, right.area) > parameters.area_ratio_max) return contradicted(Contradiction::kAreas);
  if (context.size_per_baseline) {
    const double edge = *context.size_per_baseline * j.disparity;  // px: similar triangles with the baseline
    j.expected_area = edge * edge;
    j.area = 0.5 * (left.area + right.area);
    if (j.area < parameters.expected_area_min * j.expected_area ||
        j.area > parameters.expected_area_max * j.expected_area) {
      return contradicted(Contradiction::kSize);
    }
  }
  return j;
}

}  // namespace

std::string inconsistency(const Shape& left, const Shape& right, const SelectionContext& context,
                          const SelectionParameters& parameters) {
  const Judgement j = judge(left, right, context, parameters);
  switch (j.contradiction) {
    case Contradiction::kNone:
      break;
    case Contradiction::kRows:
      return fmt::format("the blobs' rows differ by {:.1f} px, allowed {:.1f} px", j.rows, j.rows_allowed);
    case Contradiction::kDisparity:
      return fmt::format("the blobs' disparity is {:.1f} px, allowed above 0 px", j.disparity);
    case Contradiction::kHeights:
      return fmt::format("the blobs' heights are {} and {} px, allowed ratio {:.2f}", left.height, right.height,
                         parameters.height_ratio_max);
    case Contradiction::kAreas:
      return fmt::format("the blobs' areas are {:.0f} and {:.0f} px, allowed ratio {:.2f}", left.area, right.area,
                         parameters.area_ratio_max);
    case Contradiction::kSize:
      return fmt::format(
          "the blobs have {:.0f} px where the mark's size and their disparity of {:.0f} px make {:.0f} px, "
          "allowed {:.0f} to {:.0f} %",
          j.area, j.disparity, j.expected_area, 100.0 * parameters.expected_area_min,
          100.0 * parameters.expected_area_max);
  }
  return {};
}

Selection select_pair(const std::vector<Blob>& left, const std::vector<Blob>& right, const SelectionContext& context,
                      const std::optional<PairPlace>& last, const SelectionParameters& parameters) {
  Selection selection;
  if (left.empty() || right.empty()) {
    if (!left.empty()) selection.left = select_single(left, last, true);
    if (!right.empty()) selection.right = select_single(right, last, false);
    return selection;
  }
  const auto limit = static_cast<std::size_t>(std::max(1, parameters.max_candidates));
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t l = 0; l < std::min(limit, left.size()); ++l) {
    for (std::size_t r = 0; r < std::min(limit, right.size()); ++r) {
      const Shape& a = left[l].shape;
      const Shape& b = right[r].shape;
      const double score = last ? -distance_2(place_of(a, b), *last) : a.area + b.area;
      if (score <= best || judge(a, b, context, parameters).contradiction != Contradiction::kNone) continue;
      best = score;
      selection.left = l;
      selection.right = r;
    }
  }
  // The largest two are what a person would have expected to match.
  if (!selection.left) selection.reason = inconsistency(left[0].shape, right[0].shape, context, parameters);
  return selection;
}

}  // namespace markservo::mark_detector
