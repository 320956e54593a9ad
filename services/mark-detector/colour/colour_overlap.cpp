#include "services/mark-detector/colour/colour_overlap.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "services/mark-detector/colour/hue.hpp"

namespace markservo::mark_detector {
namespace {

std::string hues(const robot::MarkDescription& mark) {
  return fmt::format("{} (hue {:g} to {:g} degrees)", mark.name, mark.colour.hue_min_deg, mark.colour.hue_max_deg);
}

}  // namespace

bool overlap(const robot::ColourInterval& a, const robot::ColourInterval& b) {
  const auto holds = [](const robot::ColourInterval& interval, double hue) {
    return interval.hue_max_deg - interval.hue_min_deg >= kFullTurn_deg ||
           wrapped(hue - interval.hue_min_deg) <= wrapped(interval.hue_max_deg - interval.hue_min_deg);
  };
  return (holds(a, b.hue_min_deg) || holds(b, a.hue_min_deg)) && a.saturation_min <= b.saturation_max &&
         b.saturation_min <= a.saturation_max && a.value_min <= b.value_max && b.value_min <= a.value_max;
}

std::vector<std::string> told_of_overlaps(const std::vector<robot::MarkDescription>& marks) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    for (std::size_t j = i + 1; j < marks.size(); ++j) {
      if (!overlap(marks[i].colour, marks[j].colour)) continue;
      lines.push_back(hues(marks[i]) + " overlaps " + hues(marks[j]) + ": what has both colours is taken for both");
    }
  }
  return lines;
}

}  // namespace markservo::mark_detector
