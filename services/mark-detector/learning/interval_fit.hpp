#pragma once

// How wide a colour interval may be: as wide as is asked for, but where what is around the mark would come in.

#include <array>
#include <cstddef>
#include <vector>

#include "services/mark-detector/learning/learning_pixels.hpp"

namespace markservo::mark_detector {

// The limits of an interval. Each is a least value: upper limits count downwards, with the sign turned.
enum Limit : std::size_t { kHueLow, kHueHigh, kSaturationLow, kSaturationHigh, kValueLow, kValueHigh, kNumLimits };
using Limits = std::array<double, kNumLimits>;

// What a limit is compared with; hue in degrees from `hue_deg`, within half a turn.
double limited(const LearningPixel& pixel, std::size_t limit, double hue_deg);

struct IntervalFitParameters {
  int steps = 60;             // tried from the widest to the narrowest
  double least_gain = 0.005;  // of overlap, for which a limit is moved
  double slack = 0.02;        // of overlap, given away for a border further from what is around the mark
};

// The limits, between `widest` and `narrowest`, by which the pixels that pass overlap best with the mark: px of both
// over px of either, with each pixel the mark's by its share. Limits are taken one by one, that first which gains most
// (of a box of rules: Friedman and Fisher 1999, "bump hunting"), value's last, since it changes with the light. A limit
// that nothing comes near stays at its widest; another lies in the middle of where it serves as well. Pixels with a
// chroma below `chroma_min` pass nowhere.
Limits fit_interval(const std::vector<LearningPixel>& pixels, double hue_deg, int chroma_min, const Limits& widest,
                    const Limits& narrowest, const IntervalFitParameters& parameters = {});

}  // namespace markservo::mark_detector
