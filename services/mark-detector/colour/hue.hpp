#pragma once

// Hue, saturation and value of a colour (Smith 1978), and angles on the circle of hues.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace markservo::mark_detector {

using Bgr = std::array<double, 3>;  // blue, green, red: levels, or gains of the channels

inline constexpr double kFullTurn_deg = 360.0;
inline constexpr double kWhiteLevel = 255.0;  // level
inline constexpr int kDarkLevel = 20;         // level of the brightest channel; below it chromaticity is noise

// The angle within [0, 360).
inline double wrapped(double angle_deg) {
  const double angle = std::fmod(angle_deg, kFullTurn_deg);
  return angle < 0.0 ? angle + kFullTurn_deg : angle;
}

// The angle within [-180, 180).
inline double signed_angle(double angle_deg) {
  return wrapped(angle_deg + 0.5 * kFullTurn_deg) - 0.5 * kFullTurn_deg;
}

// How far the second interval's low end is above the first's high end, going up from the first's middle; degrees.
inline double hue_gap(double low_1, double high_1, double low_2, double high_2) {
  const double between_middles = wrapped(0.5 * (low_2 + high_2) - 0.5 * (low_1 + high_1));
  return between_middles - 0.5 * (high_1 - low_1) - 0.5 * (high_2 - low_2);
}

struct Hsv {
  double hue_deg = 0.0;     // [0, 360); 0 of grey
  double saturation = 0.0;  // [0, 1]
  double value = 0.0;       // the unit of the channels
  double chroma = 0.0;      // likewise
};

// Channels of 0 or more.
inline Hsv hsv_of(const Bgr& colour) {
  const auto [b, g, r] = colour;
  Hsv hsv;
  hsv.value = std::max({b, g, r});
  hsv.chroma = hsv.value - std::min({b, g, r});
  if (hsv.chroma <= 0.0) return hsv;
  hsv.saturation = hsv.chroma / hsv.value;
  double sixth = 0.0;
  if (hsv.value == r) {
    sixth = (g - b) / hsv.chroma;
  } else if (hsv.value == g) {
    sixth = 2.0 + (b - r) / hsv.chroma;
  } else {
    sixth = 4.0 + (r - g) / hsv.chroma;
  }
  hsv.hue_deg = wrapped(60.0 * sixth);
  return hsv;
}

// The colour of a hue, saturation in [0, 1], and value.
inline Bgr bgr_of(double hue_deg, double saturation, double value) {
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + wrapped(hue_deg) / 60.0, 6.0);
    return value * (1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return {channel(1.0), channel(3.0), channel(5.0)};
}

}  // namespace markservo::mark_detector
