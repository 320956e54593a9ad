#include "services/mark-detector/patches/patch_plan.hpp"

#include <algorithm>

namespace markservo::mark_detector {
namespace {

constexpr int kReservedSide = 32;  // patch pixels a side that even the least important mark gets

// A scale that can be had, and what both patches take; 0 for none.
struct Fit {
  int scale = 0;
  std::int64_t bytes = 0;
};

struct Span {
  int begin = 0;
  int count = 0;  // patch pixels
};

// Whole patch pixels over [box_begin - margin, box_end + margin), inside [0, size).
Span cover(int box_begin, int box_end, int margin, int scale, int size) {
  const int begin = std::max(0, box_begin - margin);
  const int end = std::min(size, box_end + margin);
  Span span;
  span.count = std::min((end - begin + scale - 1) / scale, size / scale);
  span.begin = std::min(begin, size - span.count * scale);
  return span;
}

}  // namespace

PatchFrame frame_patch(const Shape& box, const PatchParameters& parameters, int scale, int image_width,
                       int image_height) {
  const int margin = std::max(parameters.margin, parameters.margin_pixels * scale);
  const Span columns = cover(box.x, box.x + box.width, margin, scale, image_width);
  const Span rows = cover(box.y, box.y + box.height, margin, scale, image_height);
  return {columns.begin, rows.begin, scale, columns.count, rows.count};
}

void plan_scales(const std::vector<PatchRequest>& requests, const PatchParameters& parameters, int image_width,
                 int image_height, PatchPlan& plan) {
  const int greatest = std::max(1, std::min(image_width, image_height));
  // The least scale whose patches have at most `side` px and together at most `budget` bytes.
  const auto fit = [&](const PatchRequest& request, int side, std::int64_t budget) {
    for (int scale = 1; scale <= greatest; ++scale) {
      const PatchFrame left = frame_patch(request.left, parameters, scale, image_width, image_height);
      const PatchFrame right = frame_patch(request.right, parameters, scale, image_width, image_height);
      if (std::max({left.width, left.height, right.width, right.height}) > side) continue;
      const std::int64_t bytes = left.bytes() + right.bytes();
      if (bytes <= budget) return Fit{scale, bytes};
    }
    return Fit{};
  };

  plan.reserved.clear();
  std::int64_t left_over = parameters.budget;
  for (const PatchRequest& request : requests) {
    plan.reserved.push_back(fit(request, std::min(kReservedSide, parameters.limit), left_over).bytes);
    left_over -= plan.reserved.back();
  }
  plan.scales.clear();
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const Fit best = fit(requests[i], parameters.limit, left_over + plan.reserved[i]);
    left_over += plan.reserved[i] - best.bytes;
    plan.scales.push_back(best.scale);
  }
}

}  // namespace markservo::mark_detector
