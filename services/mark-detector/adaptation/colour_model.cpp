#include "services/mark-detector/adaptation/colour_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace markservo::mark_detector {
namespace {

constexpr double kWhite = 255.0;
constexpr int kClipped = 250;  // level; noise of sigma 3 brings a clipped channel down to it less than once in ten
constexpr double kMiddleLevel = 128.0;
constexpr int kDark = 20;    // level of the brightest channel; below it chromaticity is noise
constexpr int kBlended = 2;  // px along the outline that are mark and background mixed
constexpr int kMaxPerSide = 16;
constexpr double kUsualSpread = 0.3;  // of a printed mark's brightness, until it is measured
// Brightness of a print, in standard deviations from its mean.
constexpr std::array<double, 5> kBrightness = {-1.7, -0.85, 0.0, 0.85, 1.7};

void check(bool condition, const std::string& what) {
  if (!condition) throw std::invalid_argument("ColourModel: " + what);
}

double width_of(const robot::ColourInterval& interval) {
  return wrapped(interval.hue_max_deg - interval.hue_min_deg);
}

// How far the second interval's low end is above the first's high end, going up from the first's middle; degrees.
double gap(double low_1, double high_1, double low_2, double high_2) {
  const double between_middles = wrapped(0.5 * (low_2 + high_2) - 0.5 * (low_1 + high_1));
  return between_middles - 0.5 * (high_1 - low_1) - 0.5 * (high_2 - low_2);
}

// Within 64 times of what is usual, either way: no sequence of pictures leads a model beyond recall.
double bounded(double value, double usual) {
  constexpr double kMost = 64.0;
  return std::clamp(value, usual / kMost, usual * kMost);
}

// Pixels of a mark, well inside it, in both images.
class Pixels {
 public:
  void gather(const ImageView& image, const Region& mark, int per_side) {
    const int step_u = std::max(1, mark.width / per_side);
    const int step_v = std::max(1, mark.height / per_side);
    for (int v = mark.y + step_v / 2; v < mark.y + mark.height; v += step_v) {
      for (int u = mark.x + step_u / 2; u < mark.x + mark.width; u += step_u) {
        if (size_ == pixels_.size()) return;
        if (is_inside(mark, u, v)) pixels_[size_++] = image.pixel(u, v);
      }
    }
  }
  const std::uint8_t* const* begin() const { return pixels_.data(); }
  const std::uint8_t* const* end() const { return pixels_.data() + size_; }

 private:
  static bool is_inside(const Region& mark, int u, int v) {
    return mark.test(u, v) && mark.test(u - kBlended, v) && mark.test(u + kBlended, v) && mark.test(u, v - kBlended) &&
           mark.test(u, v + kBlended);
  }

  // Twice kMaxPerSide per side and image: steps are rounded down.
  std::array<const std::uint8_t*, 8UL * kMaxPerSide * kMaxPerSide> pixels_{};
  std::size_t size_ = 0;
};

// Mean and relative standard deviation of what the camera would show if it did not clip.
struct Measurement {
  Bgr mean{};
  double spread = 0.0;
  int unclipped = 0;
};

Measurement measure(const Pixels& pixels) {
  Measurement result;
  Bgr sum{};
  for (const std::uint8_t* p : pixels) {
    const int brightest = std::max({p[0], p[1], p[2]});
    if (brightest >= kClipped || brightest < kDark) continue;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += p[c];
    ++result.unclipped;
  }
  if (result.unclipped == 0) return result;
  // A clipped pixel's brightness shows in its channels that are not clipped.
  const double peak = std::max({sum[0], sum[1], sum[2]});
  double n = 0.0;
  double brightness = 0.0;
  double squares = 0.0;
  for (const std::uint8_t* p : pixels) {
    double level = 0.0;
    double share = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      if (p[c] >= kClipped || sum[c] <= share * peak) continue;
      share = sum[c] / peak;
      level = p[c];
    }
    if (share <= 0.0) continue;
    n += 1.0;
    brightness += level / share;
    squares += level * level / (share * share);
  }
  brightness /= n;
  for (std::size_t c = 0; c < 3; ++c) result.mean[c] = sum[c] / peak * brightness;
  result.spread = std::sqrt(std::max(0.0, squares / n - brightness * brightness)) / brightness;
  return result;
}

}  // namespace

ColourModel::ColourModel(const std::vector<robot::MarkDescription>& marks, int chroma_min,
                         const ColourModelParameters& parameters)
    : parameters_(parameters), chroma_min_(chroma_min) {
  check(parameters.light.columns >= 1 && parameters.light.rows >= 1, "light's grid below 1 x 1");
  check(parameters.smoothing > 0.0 && parameters.smoothing <= 1.0, "smoothing outside (0, 1]");
  check(parameters.memory_frames >= 1, "memory_frames below 1");
  check(parameters.samples_per_side >= 1 && parameters.samples_per_side <= kMaxPerSide,
        "samples_per_side outside 1 to 16");
  check(marks.size() <= robot::kMaxMarks, "more than 8 marks");
  for (const auto& mark : marks) {
    const robot::ColourInterval& interval = mark.colour;
    Nominal nominal;
    nominal.interval = interval;
    nominal.fixed = interval.hue_max_deg - interval.hue_min_deg >= kFullTurn_deg;
    nominal.low = wrapped(interval.hue_min_deg);
    nominal.high = nominal.low + width_of(interval);
    nominal.colour =
        bgr_of(0.5 * (nominal.low + nominal.high), 0.5 * (interval.saturation_min + interval.saturation_max),
               0.5 * kWhite * (interval.value_min + interval.value_max));
    nominal_.push_back(nominal);
  }
  for (Nominal& a : nominal_) {
    for (const Nominal& b : nominal_) {
      if (&a != &b && (b.fixed || gap(a.low, a.high, b.low, b.high) < 0.0)) a.shares_hue = true;
    }
  }
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

// The interval in use of one mark alone; its hues go to the ranges.
ColourModel::Range ColourModel::adapt(const Nominal& nominal, const MarkColour& mark, const Bgr& light,
                                      robot::ColourInterval& interval) const {
  interval = nominal.interval;
  Bgr mean = mark.mean;
  if (!mark.known) {
    for (std::size_t c = 0; c < 3; ++c) mean[c] = nominal.colour[c] * light[c];
  }
  const double spread = mark.known ? mark.spread : kUsualSpread;
  const double middle = 0.5 * (nominal.low + nominal.high);
  const double half_width = 0.5 * (nominal.high - nominal.low);
  Range range{middle, middle, nominal.low, nominal.high};
  double low = kFullTurn_deg;
  double high = -kFullTurn_deg;
  double pale = 1.0;
  double pure = 0.0;
  double dark = 1.0;
  double bright = 0.0;
  double noise_turn = 0.0;
  for (const double deviations : kBrightness) {
    Bgr shown{};
    for (std::size_t c = 0; c < 3; ++c) {
      shown[c] = std::min(kWhite, mean[c] * std::max(0.2, 1.0 + deviations * spread));
    }
    const Hsv hsv = hsv_of(shown);
    if (hsv.chroma < chroma_min_ || hsv.value < kDark) continue;  // black or white: no interval takes it in
    const double turn = signed_angle(hsv.hue_deg - middle);
    low = std::min(low, turn);
    high = std::max(high, turn);
    const double noise = parameters_.noise / hsv.value;
    pale = std::min(pale, hsv.saturation - 2.0 * noise);
    pure = std::max(pure, hsv.saturation + 2.0 * noise);
    dark = std::min(dark, hsv.value / kWhite);
    bright = std::max(bright, hsv.value / kWhite);
    if (deviations == 0.0) noise_turn = 2.0 * 60.0 * parameters_.noise / hsv.chroma;
  }
  if (low > high) return range;

  const double margin = std::min(parameters_.hue_margin_deg + noise_turn, parameters_.hue_margin_max_deg);
  const double furthest = half_width + parameters_.turn_max_deg;
  range.needed_low = middle + std::clamp(low, -furthest, furthest);
  range.needed_high = middle + std::clamp(high, -furthest, furthest);
  const double least = std::max(low - margin, -furthest);
  const double greatest = std::min(high + margin, furthest);
  const double down = std::max(0.0, -half_width - least);
  const double up = std::max(0.0, greatest - half_width);
  // Each end follows the other as far as the colour allows; where the prediction may be wrong, the nominal hues stay
  // in.
  const bool sure = mark.known && mark.certain;
  range.low = middle + (sure ? std::min(std::max(-half_width, least), -half_width + up) : -half_width) - down;
  range.high = middle + (sure ? std::max(std::min(half_width, greatest), half_width - down) : half_width) + up;
  if (nominal.shares_hue) return range;

  interval.saturation_min =
      std::min(interval.saturation_min,
               std::max(parameters_.saturation_share * interval.saturation_min, pale - parameters_.saturation_margin));
  if (sure) {
    // A cast gives muted things of its hue more saturation: what was too pale for the mark remains too pale.
    Bgr palest = bgr_of(middle, nominal.interval.saturation_min, 1.0);
    for (std::size_t c = 0; c < 3; ++c) palest[c] *= light[c];
    const double raised = std::min(hsv_of(palest).saturation, pale - 2.0 * parameters_.saturation_margin);
    interval.saturation_min = std::max(interval.saturation_min, raised);
  }
  interval.saturation_max = std::max(interval.saturation_max, std::min(1.0, pure + parameters_.saturation_margin));
  // Equalisation only brightens, so what passes as photographed passes.
  // Of a mark not seen yet the print's darkest is not known, but how much darker it became.
  const double least_value =
      mark.known ? parameters_.value_share * dark : interval.value_min * *std::min_element(light.begin(), light.end());
  interval.value_min = std::min(interval.value_min, least_value);
  interval.value_max = std::max(interval.value_max, std::min(1.0, bright / parameters_.value_share));
  return range;
}

void ColourModel::keep_apart(Ranges& ranges) const {
  const Ranges alone = ranges;
  for (std::size_t i = 0; i < nominal_.size(); ++i) {
    for (std::size_t j = 0; j < nominal_.size(); ++j) {
      if (i == j || nominal_[i].fixed || nominal_[j].fixed) continue;
      Range& below = ranges[i];
      Range& above = ranges[j];
      const double nominal_gap = gap(nominal_[i].low, nominal_[i].high, nominal_[j].low, nominal_[j].high);
      // From the hues of `below` to those of `above`, which may be a turn further on.
      const double turns = nominal_[i].high + nominal_gap - nominal_[j].low;
      if (nominal_gap < parameters_.gap_deg) {
        below.high = std::min(below.high, nominal_[i].high);
        above.low = std::max(above.low, nominal_[j].low);
        continue;
      }
      const Range& a = alone[i];
      const Range& b = alone[j];
      if (b.low + turns - a.high >= parameters_.gap_deg) continue;
      const double between_needed = b.needed_low + turns - a.needed_high;
      const bool told_apart = between_needed >= parameters_.gap_deg;
      const double border = told_apart ? a.needed_high + 0.5 * between_needed : nominal_[i].high + 0.5 * nominal_gap;
      below.high = std::min(below.high, border - 0.5 * parameters_.gap_deg);
      above.low = std::max(above.low, border - turns + 0.5 * parameters_.gap_deg);
    }
  }
}

const std::vector<ColourRule>& ColourModel::rules(const ImageView& image, ColourState& state) const {
  predict(light_change(image, parameters_.light, state.samples), state);
  state.intervals.resize(nominal_.size());
  state.rules.resize(nominal_.size());
  Ranges ranges{};
  for (std::size_t i = 0; i < nominal_.size(); ++i) {
    if (nominal_[i].fixed) {
      state.intervals[i] = nominal_[i].interval;
      continue;
    }
    ranges[i] = adapt(nominal_[i], state.marks[i], state.light, state.intervals[i]);
  }
  keep_apart(ranges);
  for (std::size_t i = 0; i < nominal_.size(); ++i) {
    robot::ColourInterval& interval = state.intervals[i];
    const Range& range = ranges[i];
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

bool ColourModel::observe(std::size_t mark, const ImageView& left, const Region& in_left, const ImageView& right,
                          const Region& in_right, ColourState& state) const {
  Pixels pixels;
  pixels.gather(left, in_left, parameters_.samples_per_side);
  pixels.gather(right, in_right, parameters_.samples_per_side);
  const Measurement measured = measure(pixels);
  MarkColour& colour = state.marks.at(mark);
  if (measured.unclipped < parameters_.least_samples) {
    // Whatever is overexposed looks alike.
    if (colour.age <= 1) colour.age = 0;
    return !colour.known;
  }
  if (colour.known && colour.certain) {
    const Hsv now = hsv_of(measured.mean);
    const Hsv predicted = hsv_of(colour.mean);
    const double jump = std::hypot(signed_angle(now.hue_deg - predicted.hue_deg) / parameters_.hue_jump_max_deg,
                                   (now.saturation - predicted.saturation) / parameters_.saturation_jump_max);
    if (!(jump <= 1.0)) return false;
  }
  const double share = colour.known ? parameters_.smoothing : 1.0;
  for (std::size_t c = 0; c < 3; ++c) colour.mean[c] += share * (measured.mean[c] - colour.mean[c]);
  colour.spread += share * (measured.spread - colour.spread);
  colour.known = true;
  colour.certain = true;
  colour.age = 0;
  return true;
}

}  // namespace markservo::mark_detector
