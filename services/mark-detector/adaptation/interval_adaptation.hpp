#pragma once

// The interval in use of a mark: the nominal one, turned and relaxed by no more than is needed for the mark's colour,
// over the range of its print's brightness and clipped at 255 as the camera clips it, to lie well inside.

#include <array>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/adaptation/mark_colour.hpp"

namespace markservo::mark_detector {

struct IntervalParameters {
  double noise = 3.0;           // levels, sigma of the camera's noise
  double hue_margin_deg = 8.0;  // how far inside its interval a colour must lie, besides twice the noise's turn
  double hue_margin_max_deg = 20.0;
  double saturation_margin = 0.08;  // likewise, besides twice the noise
  double saturation_share = 0.5;    // of the nominal least saturation: below it, pale things of the same hue come in
  double value_share = 0.8;         // of the darkest print's value that still passes
  double turn_max_deg = 35.0;       // past an end of the nominal interval: blue that clips turns by 30 degrees
  double gap_deg = 4.0;             // kept between two marks' intervals
};

// Hues that a mark needs, and those in use: degrees, unwrapped, about its nominal interval.
struct HueRange {
  double needed_low = 0.0;
  double needed_high = 0.0;
  double low = 0.0;
  double high = 0.0;
};
using HueRanges = std::array<HueRange, robot::kMaxMarks>;

// The interval in use of one mark alone but for its hues, which are returned. `light`: gains of the channels since the
// beginning, for a mark whose colour is not known; `chroma_min`: make_rule.
HueRange adapt_interval(const NominalColour& nominal, const MarkColour& mark, const Bgr& light, int chroma_min,
                        const IntervalParameters& parameters, robot::ColourInterval& interval);

// Narrows ranges that come nearer to each other than the gap. A border lies in the middle of what two marks need, or
// else of what is nominally between them.
void keep_apart(const std::vector<NominalColour>& nominal, double gap_deg, HueRanges& ranges);

}  // namespace markservo::mark_detector
