#include "services/mark-detector/colour_classifier.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace markservo::mark_detector {
namespace {

constexpr double kFullTurn_deg = 360.0;
constexpr double kLeastWidth_deg = 0.1;  // below it the integer cone would degenerate to a line

struct Ray {
  int16_t x = 0;
  int16_t y = 0;
};

int16_t scaled(double ratio, int scale) {
  return static_cast<int16_t>(std::lround(ratio * scale));
}

// (R - G, G - B) of the purest colour of a hue.
Ray ray_of(double hue_deg) {
  const double sixth = std::fmod(std::fmod(hue_deg, kFullTurn_deg) + kFullTurn_deg, kFullTurn_deg) / 60.0;
  const auto channel = [sixth](double peak) {
    double distance = std::abs(sixth - peak);
    distance = std::min(distance, 6.0 - distance);
    return std::clamp(2.0 - distance, 0.0, 1.0);
  };
  const double r = channel(0.0);
  const double g = channel(2.0);
  const double b = channel(4.0);
  return {scaled(r - g, ColourRule::kHueScale), scaled(g - b, ColourRule::kHueScale)};
}

// What all rules ask of a row of pixels.
struct RowFeatures {
  explicit RowFeatures(int width)
      : x(static_cast<std::size_t>(width)), y(x.size()), chroma(x.size()), value(x.size()), shifted(x.size()) {}
  std::vector<int16_t> x;
  std::vector<int16_t> y;
  std::vector<int16_t> chroma;
  std::vector<int16_t> value;
  std::vector<int16_t> shifted;  // V'
};

void extract(const ImageView& image, int v, const LumaShift& shift, RowFeatures& row) {
  const uint8_t* p = image.row(v);
  // A byte may alias anything: only plain restricted pointers let the compiler keep what it has loaded.
  int16_t* __restrict x = row.x.data();
  int16_t* __restrict y = row.y.data();
  int16_t* __restrict chroma = row.chroma.data();
  int16_t* __restrict value = row.value.data();
  int16_t* __restrict shifted = row.shifted.data();
  for (int u = 0; u < image.width; ++u, p += 3) {
    const int b = p[0];
    const int g = p[1];
    const int r = p[2];
    const int high = std::max(b, std::max(g, r));
    const int low = std::min(b, std::min(g, r));
    x[u] = static_cast<int16_t>(r - g);
    y[u] = static_cast<int16_t>(g - b);
    chroma[u] = static_cast<int16_t>(high - low);
    value[u] = static_cast<int16_t>(high);
    shifted[u] = static_cast<int16_t>(std::clamp(high + shift[static_cast<std::size_t>(luma(b, g, r))], 0, 255));
  }
}

// Without branches, so that the loop over a row becomes vector code.
inline unsigned matches(const ColourRule& rule, int16_t x, int16_t y, int16_t chroma, int16_t value, int16_t shifted) {
  const unsigned after_min = rule.min_x * y - rule.min_y * x >= 0 ? 1U : 0U;
  const unsigned before_max = x * rule.max_y - y * rule.max_x >= 0 ? 1U : 0U;
  const unsigned both = after_min & before_max;
  const unsigned either = after_min | before_max;
  const unsigned hue = (rule.any_hue ? 1U : 0U) | (rule.wide ? either : both);
  const int scaled_chroma = chroma * ColourRule::kSaturationScale;
  const unsigned saturation = (scaled_chroma >= rule.saturation_min * value ? 1U : 0U) &
                              (scaled_chroma <= rule.saturation_max * value ? 1U : 0U);
  const unsigned brightness = (shifted >= rule.value_min ? 1U : 0U) & (shifted <= rule.value_max ? 1U : 0U);
  return hue & saturation & brightness & (chroma >= rule.chroma_min ? 1U : 0U);
}

void classify_row(const ColourRule& rule, const RowFeatures& row, std::vector<uint8_t>& bytes) {
  const ColourRule own = rule;
  const int16_t* __restrict x = row.x.data();
  const int16_t* __restrict y = row.y.data();
  const int16_t* __restrict chroma = row.chroma.data();
  const int16_t* __restrict value = row.value.data();
  const int16_t* __restrict shifted = row.shifted.data();
  uint8_t* __restrict out = bytes.data();
  const std::size_t n = bytes.size();
  for (std::size_t u = 0; u < n; ++u) {
    out[u] = static_cast<uint8_t>(matches(own, x[u], y[u], chroma[u], value[u], shifted[u]));
  }
}

}  // namespace

ColourRule make_rule(const robot::ColourInterval& interval, int chroma_min) {
  for (const double number : {interval.hue_min_deg, interval.hue_max_deg, interval.saturation_min,
                              interval.saturation_max, interval.value_min, interval.value_max}) {
    if (!std::isfinite(number)) throw std::invalid_argument("make_rule: colour interval is not finite");
  }
  double width = interval.hue_max_deg - interval.hue_min_deg;
  ColourRule rule;
  rule.any_hue = width >= kFullTurn_deg;
  width = std::fmod(std::fmod(width, kFullTurn_deg) + kFullTurn_deg, kFullTurn_deg);
  const double widened = std::max(0.0, 0.5 * (kLeastWidth_deg - width));
  const Ray least = ray_of(interval.hue_min_deg - widened);
  const Ray greatest = ray_of(interval.hue_max_deg + widened);
  rule.wide = width > 0.5 * kFullTurn_deg;
  rule.min_x = least.x;
  rule.min_y = least.y;
  rule.max_x = greatest.x;
  rule.max_y = greatest.y;
  rule.saturation_min = scaled(std::clamp(interval.saturation_min, 0.0, 1.0), ColourRule::kSaturationScale);
  rule.saturation_max = scaled(std::clamp(interval.saturation_max, 0.0, 1.0), ColourRule::kSaturationScale);
  rule.value_min = scaled(std::clamp(interval.value_min, 0.0, 1.0), 255);
  rule.value_max = scaled(std::clamp(interval.value_max, 0.0, 1.0), 255);
  rule.chroma_min = static_cast<int16_t>(std::clamp(chroma_min, 0, 255));
  return rule;
}

bool belongs(const ColourRule& rule, int b, int g, int r, int shift) {
  const int high = std::max(b, std::max(g, r));
  const int low = std::min(b, std::min(g, r));
  const auto narrow = [](int number) { return static_cast<int16_t>(number); };
  return matches(rule, narrow(r - g), narrow(g - b), narrow(high - low), narrow(high),
                 narrow(std::clamp(high + shift, 0, 255))) != 0;
}

std::vector<BitMask> classify(const ImageView& image, const LumaShift& shift, const std::vector<ColourRule>& rules) {
  std::vector<BitMask> masks(rules.size(), BitMask(image.width, image.height));
  RowFeatures row(image.width);
  std::vector<uint8_t> bytes(static_cast<std::size_t>(image.width));
  for (int v = 0; v < image.height; ++v) {
    extract(image, v, shift, row);
    for (std::size_t k = 0; k < rules.size(); ++k) {
      classify_row(rules[k], row, bytes);
      masks[k].set_row(v, bytes.data());
    }
  }
  return masks;
}

}  // namespace markservo::mark_detector
