#include "services/mark-detector/adaptation/mark_colour.hpp"

namespace markservo::mark_detector {

std::vector<NominalColour> nominal_colours(const std::vector<robot::MarkDescription>& marks) {
  std::vector<NominalColour> colours;
  for (const auto& mark : marks) {
    const robot::ColourInterval& interval = mark.colour;
    NominalColour nominal;
    nominal.interval = interval;
    nominal.fixed = interval.hue_max_deg - interval.hue_min_deg >= kFullTurn_deg;
    nominal.low = wrapped(interval.hue_min_deg);
    nominal.high = nominal.low + wrapped(interval.hue_max_deg - interval.hue_min_deg);
    nominal.colour =
        bgr_of(0.5 * (nominal.low + nominal.high), 0.5 * (interval.saturation_min + interval.saturation_max),
               0.5 * kWhiteLevel * (interval.value_min + interval.value_max));
    colours.push_back(nominal);
  }
  for (NominalColour& a : colours) {
    for (const NominalColour& b : colours) {
      if (&a != &b && (b.fixed || hue_gap(a.low, a.high, b.low, b.high) < 0.0)) a.shares_hue = true;
    }
  }
  return colours;
}

}  // namespace markservo::mark_detector
