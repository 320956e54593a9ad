#include "services/mark-detector/patches/pair_patches.hpp"

#include <algorithm>
#include <tuple>

#include "services/mark-detector/views/pair_place.hpp"

namespace markservo::mark_detector {
namespace {

PairPlace place_of(const Finding& finding) {
  return place_of(finding.left.shape, finding.right.shape);
}

// Indices of the marks that both images see.
void by_importance(const std::vector<Finding>& findings, int width, int height, std::vector<std::size_t>& order) {
  order.clear();
  PairPlace focus{0.5 * (width - 1), 0.5 * (height - 1), 0.5 * (width - 1)};
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Finding& finding = findings[i];
    if (!finding.seen_by_both()) continue;
    order.push_back(i);
    if (finding.role == robot::MarkRole::kManipulator) focus = place_of(finding);
  }
  const auto rank = [&](std::size_t i) {
    const bool hand = findings[i].role == robot::MarkRole::kManipulator;
    return std::make_tuple(hand ? 0 : 1, distance_2(place_of(findings[i]), focus), i);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
}

void clear(Patch& patch) {
  patch.scale = patch.width = patch.height = 0;
  patch.bgr.clear();
  patch.mask.clear();
}

}  // namespace

void PairPatches::cut(const Input& input, const PatchParameters& parameters, std::vector<Finding>& findings) {
  for (Finding& finding : findings) {
    clear(finding.left.patch);
    clear(finding.right.patch);
  }
  if (input.single()) return;
  const int width = input.left.width;
  const int height = input.left.height;
  by_importance(findings, width, height, order_);
  requests_.clear();
  for (const std::size_t i : order_) requests_.push_back({findings[i].left.shape, findings[i].right.shape});
  plan_scales(requests_, parameters, width, height, plan_);
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const int scale = plan_.scales[k];
    if (scale == 0) continue;
    Finding& finding = findings[order_[k]];
    const auto cut_view = [&](const ImageView& image, View& view) {
      cutter_.cut(image, view.region, frame_patch(view.shape, parameters, scale, width, height), view.patch);
    };
    cut_view(input.left, finding.left);
    cut_view(input.right, finding.right);
  }
}

}  // namespace markservo::mark_detector
