#include "services/mark-detector/adaptation/colour_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace markservo::mark_detector {
namespace {

constexpr double kMiddleLevel = 128.0;

void check(bool condition, const std::string& what) {
  if (!condition) throw std::invalid_argument("ColourModel: " + what);
}

// Within 64 times of what is usual, either way: no sequence of pictures leads a model beyond recall.
double bounded(double value, double usual) {
  constexpr double kMost = 64.0;
  return std::clamp(value, usual / kMost, usual * kMost);
}

}  // namespace

ColourModel::ColourModel(const std::vector<robot::MarkDescription>& marks, int chroma_min,
                         const ColourModelParameters& parameters)
    : parameters_(parameters), chroma_min_(chroma_min), nominal_(nominal_colours(marks)) {
  const int per_side = parameters.measurement.samples_per_side;
  check(parameters.light.columns >= 1 && parameters.light.rows >= 1, "light's grid below 1 x 1");
  check(parameters.smoothing > 0.0 && parameters.smoothing <= 1.0, "smoothing outside (0, 1]");
  check(parameters.memory_frames >= 1, "memory_frames below 1");
  check(per_side >= 1 && per_side <= kMaxSamplesPerSide, "samples_per_side outside 1 to 16");
  check(marks.size() <= robot::kMaxMarks, "more than 8 marks");
}

void ColourModel::predict(const LightChange& change, ColourState& state) const {
  const double kept = 1.0 - 1.0 / parameters_.memory_frames;
  for (std::size_t c = 0; c < 3; ++c) state.light[c] = bounded(std::pow(state.light[c] * change.gains[c], kept), 1.0);
  state.marks.resize(nominal_.size());
  for (MarkColour& mark : state.marks) {
    if (!mark.known) continue;
    mark.known = ++mark.age <= parameters_.memory_frames;
    mark.certain = mark.certain && change.certain;
    for (std::size_t c = 0; c < 3; ++c) mark.mean[c] = bounded(mark.mean[c] * change.gains[c], kMiddleLevel);
  }
}

const std::vector<ColourRule>& ColourModel::rules(const ImageView& image, ColourState& state) const {
  predict(light_change(image, parameters_.light, state.samples), state);
  state.intervals.resize(nominal_.size());
  state.rules.resize(nominal_.size());
  HueRanges ranges{};
  for (std::size_t i = 0; i < nominal_.size(); ++i) {
    if (nominal_[i].fixed) {
      state.intervals[i] = nominal_[i].interval;
      continue;
    }
    ranges[i] =
        adapt_interval(nominal_[i], state.marks[i], state.light, chroma_min_, parameters_.interval, state.intervals[i]);
  }
  keep_apart(nominal_, parameters_.interval.gap_deg, ranges);
  for (std::size_t i = 0; i < nominal_.size(); ++i) {
    robot::ColourInterval& interval = state.intervals[i];
    const HueRange& range = ranges[i];
    const bool moved = range.low != nominal_[i].low || range.high != nominal_[i].high;
    // What is left between two neighbours may be nothing: then better the nominal hues.
    if (!nominal_[i].fixed && moved && range.high > range.low) {
      interval.hue_min_deg = wrapped(range.low);
      interval.hue_max_deg = wrapped(range.high);
    }
    state.rules[i] = make_rule(interval, chroma_min_);
  }
  return state.rules;
}

// Further from the prediction than one mark's colour goes from frame to frame.
bool ColourModel::jumps(const MarkColour& predicted, const ColourMeasurement& measured) const {
  const Hsv now = hsv_of(measured.mean);
  const Hsv before = hsv_of(predicted.mean);
  const double jump = std::hypot(signed_angle(now.hue_deg - before.hue_deg) / parameters_.hue_jump_max_deg,
                                 (now.saturation - before.saturation) / parameters_.saturation_jump_max);
  return !(jump <= 1.0);
}

bool ColourModel::observe(std::size_t mark, const ImageView& left, const Region& in_left, const ImageView& right,
                          const Region& in_right, ColourState& state) const {
  const ColourMeasurement measured =
      measure_colour(left, in_left, right, in_right, parameters_.measurement.samples_per_side);
  MarkColour& colour = state.marks.at(mark);
  if (measured.unclipped < parameters_.measurement.least_samples) {
    // Whatever is overexposed looks alike.
    if (colour.age <= 1) colour.age = 0;
    return !colour.known;
  }
  if (colour.sure() && jumps(colour, measured)) return false;
  const double share = colour.known ? parameters_.smoothing : 1.0;
  for (std::size_t c = 0; c < 3; ++c) colour.mean[c] += share * (measured.mean[c] - colour.mean[c]);
  colour.spread += share * (measured.spread - colour.spread);
  colour.known = true;
  colour.certain = true;
  colour.age = 0;
  return true;
}

}  // namespace markservo::mark_detector
