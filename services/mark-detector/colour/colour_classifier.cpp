#include "services/mark-detector/colour/colour_classifier.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "services/mark-detector/colour/hue.hpp"

namespace markservo::mark_detector {
namespace {

constexpr double kLeastWidth_deg = 0.1;  // below it the integer cone would degenerate to a line

struct Ray {
  std::int16_t x = 0;
  std::int16_t y = 0;
};

std::int16_t scaled(double ratio, int scale) {
  return static_cast<std::int16_t>(std::lround(ratio * scale));
}

// (R - G, G - B) of the purest colour of a hue, kHueScale long.
Ray ray_of(double hue_deg) {
  const auto [b, g, r] = bgr_of(hue_deg, 1.0, 1.0);
  return {scaled(r - g, ColourRule::kHueScale), scaled(g - b, ColourRule::kHueScale)};
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
  width = wrapped(width);
  const double widened = std::max(0.0, 0.5 * (kLeastWidth_deg - width));
  const double hue_min = interval.hue_min_deg - widened;
  const double hue_max = interval.hue_max_deg + widened;
  const Ray least = ray_of(hue_min);
  const Ray greatest = ray_of(hue_max);
  rule.wide = width > 0.5 * kFullTurn_deg;
  rule.min_x = least.x;
  rule.min_y = least.y;
  rule.max_x = greatest.x;
  rule.max_y = greatest.y;
  rule.saturation_min = scaled(std::clamp(interval.saturation_min, 0.0, 1.0), ColourRule::kSaturationScale);
  rule.saturation_max = scaled(std::clamp(interval.saturation_max, 0.0, 1.0), ColourRule::kSaturationScale);
  rule.value_min = scaled(std::clamp(interval.value_min, 0.0, 1.0), 255);
  rule.value_max = scaled(std::clamp(interval.value_max, 0.0, 1.0), 255);
  rule.chroma_min = static_cast<std::int16_t>(std::clamp(chroma_min, 0, 255));
  return rule;
}

bool belongs(const ColourRule& rule, int b, int g, int r, int shift) {
  const int x = r - g;
  const int y = g - b;
  const int value = std::max({b, g, r});
  const int chroma = value - std::min({b, g, r});
  const int shifted = std::clamp(value + shift, 0, 255);
  const bool after_min = rule.min_x * y >= rule.min_y * x;
  const bool before_max = rule.max_y * x >= rule.max_x * y;
  const bool hue = rule.any_hue || (rule.wide ? after_min || before_max : after_min && before_max);
  const int scaled_chroma = chroma * ColourRule::kSaturationScale;
  return hue && scaled_chroma >= rule.saturation_min * value && scaled_chroma <= rule.saturation_max * value &&
         shifted >= rule.value_min && shifted <= rule.value_max && chroma >= rule.chroma_min;
}

}  // namespace markservo::mark_detector
