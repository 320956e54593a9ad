#include "services/mark-detector/colour_classifier.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace markservo::mark_detector {
namespace {

constexpr double kFullTurn_deg = 360.0;
constexpr double kCoarse_deg = 0.5;      // twice what rounding to kCoarseScale can turn a ray by
constexpr double kLeastWidth_deg = 0.1;  // below it the integer cone would degenerate to a line

struct Ray {
  int16_t x = 0;
  int16_t y = 0;
};

int16_t scaled(double ratio, int scale) {
  return static_cast<int16_t>(std::lround(ratio * scale));
}

// (R - G, G - B) of the purest colour of a hue, `scale` long.
Ray ray_of(double hue_deg, int scale) {
  const double sixth = std::fmod(std::fmod(hue_deg, kFullTurn_deg) + kFullTurn_deg, kFullTurn_deg) / 60.0;
  const auto channel = [sixth](double peak) {
    double distance = std::abs(sixth - peak);
    distance = std::min(distance, 6.0 - distance);
    return std::clamp(2.0 - distance, 0.0, 1.0);
  };
  const double r = channel(0.0);
  const double g = channel(2.0);
  const double b = channel(4.0);
  return {scaled(r - g, scale), scaled(g - b, scale)};
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
  const double hue_min = interval.hue_min_deg - widened;
  const double hue_max = interval.hue_max_deg + widened;
  const Ray least = ray_of(hue_min, ColourRule::kHueScale);
  const Ray greatest = ray_of(hue_max, ColourRule::kHueScale);
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

  const Ray coarse_least = ray_of(hue_min - kCoarse_deg, ColourRule::kCoarseScale);
  const Ray coarse_greatest = ray_of(hue_max + kCoarse_deg, ColourRule::kCoarseScale);
  rule.coarse_any_hue = rule.any_hue || width + 2.0 * kCoarse_deg >= kFullTurn_deg;
  rule.coarse_wide = width + 2.0 * kCoarse_deg > 0.5 * kFullTurn_deg;
  rule.coarse_min_x = coarse_least.x;
  rule.coarse_min_y = coarse_least.y;
  rule.coarse_max_x = coarse_greatest.x;
  rule.coarse_max_y = coarse_greatest.y;
  rule.coarse_saturation_min =
      static_cast<int16_t>(rule.saturation_min * ColourRule::kCoarseScale / ColourRule::kSaturationScale);
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
