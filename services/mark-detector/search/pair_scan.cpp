#include "services/mark-detector/search/pair_scan.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace markservo::mark_detector {

void PairMasks::reset(std::size_t num_marks, int width, int height) {
  for (std::size_t i = 0; i < num_marks; ++i) {
    left[i].reset(width, height);
    right[i].reset(width, height);
  }
}

void PairScan::search_everywhere(MarkSet marks) const {
  if (marks.none()) return;
  for (const auto& [image, masks] : {std::pair(&left_, &masks_.left), std::pair(&right_, &masks_.right)}) {
    if (image->empty()) continue;
    ScanRules rules;
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      if (marks[i]) rules.add(rules_[i], (*masks)[i]);
    }
    scan(*image, whole_image(*image), shift_, rules);
  }
}

MarkSet PairScan::in_sight(MarkSet marks, int first_row, const SearchParameters& parameters) const {
  MarkSet in_sight;
  for (const auto& [image, masks] : {std::pair(&left_, &masks_.left), std::pair(&right_, &masks_.right)}) {
    ScanRules rules;
    std::array<std::size_t, robot::kMaxMarks> mark_of_rule{};
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      if (!marks[i] || in_sight[i]) continue;
      mark_of_rule.at(rules.count) = i;
      rules.add(rules_[i], (*masks)[i]);
    }
    if (rules.count == 0) break;
    const std::uint32_t found =
        scan_rows(*image, first_row, parameters.coarse_rows, parameters.coarse_least, shift_, rules);
    for (std::size_t k = 0; k < rules.count; ++k) {
      if (((found >> k) & 1U) != 0) in_sight.set(mark_of_rule.at(k));
    }
  }
  return in_sight;
}

PairWindow PairScan::search_around(std::size_t mark, const Shape& last_left, const Shape& last_right,
                                   int margin) const {
  const auto search_side = [&](const ImageView& image, const Shape& last, imaging::BitMask& mask) {
    const ScanWindow window = window_around(last, margin + std::max(last.width, last.height) / 8, image);
    ScanRules rules;
    rules.add(rules_[mark], mask);
    scan(image, window, shift_, rules);
    return window;
  };
  return {search_side(left_, last_left, masks_.left[mark]), search_side(right_, last_right, masks_.right[mark])};
}

}  // namespace markservo::mark_detector
