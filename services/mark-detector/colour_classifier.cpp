#include "services/mark-detector/colour_classifier.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "services/mark-detector/colour_kernel.hpp"

namespace markservo::mark_detector {
namespace {

constexpr std::size_t kMaxRules = 8;  // as many marks as a robot's description may have
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
  const int high = std::max(b, std::max(g, r));
  const int low = std::min(b, std::min(g, r));
  const auto narrow = [](int number) { return static_cast<int16_t>(number); };
  return matches(rule, narrow(r - g), narrow(g - b), narrow(high - low), narrow(high),
                 narrow(std::clamp(high + shift, 0, 255))) != 0;
}

void classify(const ImageView& image, const LumaShift& shift, const std::vector<ColourRule>& rules,
              std::vector<BitMask>& masks) {
  masks.resize(rules.size());
  for (BitMask& mask : masks) mask.resize(image.width, image.height);
  const std::vector<FrameRule> prepared = frame_rules(rules, shift);
  std::array<uint64_t*, kMaxRules> rows{};
  for (int v = 0; v < image.height; ++v) {
    for (std::size_t k = 0; k < rules.size(); ++k) rows.at(k) = masks[k].row(v);
    classify_row(image.row(v), image.width, prepared, shift, rows.data());
  }
}

}  // namespace markservo::mark_detector
