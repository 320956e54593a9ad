#pragma once

// Which pixels have a mark's colour (paper, vision chain 2).
//
// With B, G, R the pixel as photographed, Y its luma and shift(Y) what equalisation adds to all three:
//   x = R - G, y = G - B          neither changes with equalisation; hue is the direction of (x, y)
//   C = max(B, G, R) - min(B, G, R)     chroma, unchanged as well
//   V = max(B, G, R),  V' = clamp(V + shift(Y), 0, 255)
// A pixel belongs to an interval if
//   hue:         (x, y) lies in the cone between the rays of hue_min and hue_max: two half-planes
//   saturation:  saturation_min V <= C <= saturation_max V
//   value:       255 value_min <= V' <= 255 value_max
//   noise:       C >= chroma_min
// Saturation is the photographed pixel's, for C and V grow alike with light; that of the equalised one would fall with
// light, because equalisation restores luma but not chroma. All tests are exact integer inequalities, so every
// implementation must give the same bits.

#include <cstdint>

#include "common/robot/robot_description.hpp"

namespace markservo::mark_detector {

// A colour interval as integer inequalities; products of two fit 32 bits.
struct ColourRule {
  static constexpr int kHueScale = 1 << 14;
  static constexpr int kSaturationScale = 1 << 12;

  bool any_hue = false;
  bool wide = false;       // the cone is wider than half a turn: one half-plane is enough
  std::int16_t min_x = 0;  // kHueScale times the ray of hue_min in (x, y)
  std::int16_t min_y = 0;
  std::int16_t max_x = 0;  // likewise of hue_max
  std::int16_t max_y = 0;
  std::int16_t saturation_min = 0;  // kSaturationScale times the ratio C / V
  std::int16_t saturation_max = kSaturationScale;
  std::int16_t value_min = 0;  // levels
  std::int16_t value_max = 255;
  std::int16_t chroma_min = 0;  // levels
};

// The rule of an interval. Hue wraps; an interval of 360 degrees or more takes every hue, one narrower than 0.1 degrees
// is widened to that. `chroma_min`: levels, see above. Hues in degrees, saturation and value in [0, 1]; throws
// std::invalid_argument on numbers that are not finite.
ColourRule make_rule(const robot::ColourInterval& interval, int chroma_min);

// True if a pixel belongs; `shift` is its luma's.
bool belongs(const ColourRule& rule, int b, int g, int r, int shift);

}  // namespace markservo::mark_detector
