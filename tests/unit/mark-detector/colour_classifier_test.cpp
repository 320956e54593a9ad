#include "services/mark-detector/colour/colour_classifier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>

#include "services/mark-detector/search/colour_scan.hpp"

namespace markservo::mark_detector {
namespace {

using robot::ColourInterval;

struct Hsv {
  double hue = 0.0;  // degrees
  double saturation = 0.0;
  double value = 0.0;
};

// The textbook's formula, which divides.
Hsv hsv_of(int b, int g, int r) {
  const int high = std::max({b, g, r});
  const double chroma = high - std::min({b, g, r});
  Hsv hsv;
  hsv.value = high / 255.0;
  if (high > 0) hsv.saturation = chroma / high;
  if (chroma == 0.0) return hsv;
  if (high == r) {
    hsv.hue = 60.0 * (g - b) / chroma;
  } else if (high == g) {
    hsv.hue = 120.0 + 60.0 * (b - r) / chroma;
  } else {
    hsv.hue = 240.0 + 60.0 * (r - g) / chroma;
  }
  if (hsv.hue < 0.0) hsv.hue += 360.0;
  return hsv;
}

bool in_turn(double hue, double least, double greatest) {
  return least <= greatest ? hue >= least && hue <= greatest : hue >= least || hue <= greatest;
}

// How near the pixel is to a limit of the interval, where rounding may decide.
bool borderline(const Hsv& hsv, const ColourInterval& interval) {
  const auto turn = [](double a, double b) { return std::abs(std::remainder(a - b, 360.0)); };
  return turn(hsv.hue, interval.hue_min_deg) < 0.02 || turn(hsv.hue, interval.hue_max_deg) < 0.02 ||
         std::abs(hsv.saturation - interval.saturation_min) < 3e-4 ||
         std::abs(hsv.saturation - interval.saturation_max) < 3e-4 || std::abs(hsv.value - interval.value_min) < 3e-3 ||
         std::abs(hsv.value - interval.value_max) < 3e-3;
}

TEST(ColourClassifier, IsTheHsvIntervalWithoutDivision) {
  const ColourInterval intervals[] = {
      {95.0, 150.0, 0.40, 1.0, 0.15, 1.0}, {345.0, 15.0, 0.50, 1.0, 0.20, 1.0}, {40.0, 72.0, 0.45, 0.9, 0.25, 0.8},
      {200.0, 245.0, 0.0, 1.0, 0.0, 1.0},  {300.0, 200.0, 0.2, 1.0, 0.1, 1.0},  {10.0, 350.0, 0.1, 0.7, 0.0, 0.9},
      {0.0, 180.0, 0.3, 1.0, 0.1, 1.0},    {90.0, 91.0, 0.1, 1.0, 0.1, 1.0},
  };
  std::mt19937 random(7);
  std::uniform_int_distribution<int> level(0, 255);
  for (const auto& interval : intervals) {
    const ColourRule rule = make_rule(interval, 1);
    int inside = 0;
    for (int i = 0; i < 200000; ++i) {
      const int b = level(random);
      const int g = level(random);
      const int r = level(random);
      const Hsv hsv = hsv_of(b, g, r);
      if (borderline(hsv, interval) || (b == g && g == r)) continue;
      const bool expected = in_turn(hsv.hue, interval.hue_min_deg, interval.hue_max_deg) &&
                            hsv.saturation >= interval.saturation_min && hsv.saturation <= interval.saturation_max &&
                            hsv.value >= interval.value_min && hsv.value <= interval.value_max;
      ASSERT_EQ(belongs(rule, b, g, r, 0), expected)
          << interval.hue_min_deg << ".." << interval.hue_max_deg << ": " << b << " " << g << " " << r;
      inside += expected ? 1 : 0;
    }
    EXPECT_GT(inside, 50);
  }
}

TEST(ColourClassifier, TakesEveryHueOverAFullTurn) {
  const ColourRule rule = make_rule({0.0, 360.0, 0.5, 1.0, 0.1, 1.0}, 1);
  EXPECT_TRUE(belongs(rule, 0, 0, 200, 0));
  EXPECT_TRUE(belongs(rule, 0, 200, 0, 0));
  EXPECT_TRUE(belongs(rule, 200, 0, 100, 0));
  EXPECT_FALSE(belongs(rule, 100, 100, 100, 0));
}

TEST(ColourClassifier, TakesOneHueButNotTheOppositeFromANarrowInterval) {
  const ColourRule rule = make_rule({0.0, 0.0, 0.5, 1.0, 0.1, 1.0}, 1);
  EXPECT_TRUE(belongs(rule, 0, 0, 200, 0));
  EXPECT_FALSE(belongs(rule, 200, 200, 0, 0));
  EXPECT_FALSE(belongs(rule, 0, 30, 200, 0));
}

TEST(ColourClassifier, JudgesValueAfterEqualisationAndSaturationBefore) {
  const ColourRule rule = make_rule({345.0, 15.0, 0.5, 1.0, 0.4, 1.0}, 1);
  EXPECT_FALSE(belongs(rule, 8, 8, 50, 0)) << "too dark as photographed";
  EXPECT_TRUE(belongs(rule, 8, 8, 50, 60)) << "bright enough when equalised, and as saturated as ever";
  EXPECT_FALSE(belongs(rule, 8, 8, 150, -100)) << "darkened by equalisation";
}

TEST(ColourClassifier, DoesNotTakeNoiseOnGreyForAColour) {
  const ColourRule rule = make_rule({0.0, 360.0, 0.2, 1.0, 0.0, 1.0}, 14);
  EXPECT_FALSE(belongs(rule, 10, 14, 20, 0));
  EXPECT_TRUE(belongs(rule, 10, 14, 24, 0));
}

TEST(ColourClassifier, GivesTheSameBitsPixelByPixelAndByRows) {
  constexpr int kWidth = 131;
  constexpr int kHeight = 17;
  constexpr std::ptrdiff_t kStride = 3 * kWidth + 5;  // rows need not be dense
  std::mt19937 random(3);
  std::uniform_int_distribution<int> level(0, 255);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(kStride) * kHeight);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(level(random));
  const ImageView image{bytes.data(), kWidth, kHeight, kStride};
  LumaHistogram histogram{};
  accumulate(image, histogram);
  const LumaShift shift = equalising_shift(histogram);
  const std::vector<ColourRule> rules = {make_rule({345.0, 15.0, 0.3, 1.0, 0.2, 1.0}, 10),
                                         make_rule({30.0, 300.0, 0.1, 0.9, 0.1, 0.9}, 0)};
  std::vector<FrameRule> for_frame;
  frame_rules(rules, shift, for_frame);
  std::vector<imaging::BitMask> masks(rules.size());
  ScanRules scanned;
  for (std::size_t k = 0; k < rules.size(); ++k) {
    masks[k].reset(kWidth, kHeight);
    scanned.add(for_frame[k], masks[k]);
  }
  scan(image, whole_image(image), shift, scanned);
  for (std::size_t k = 0; k < rules.size(); ++k) {
    EXPECT_GT(masks[k].count(), 20);
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        const std::uint8_t* p = image.pixel(u, v);
        const int added = shift[static_cast<std::size_t>(luma(p[0], p[1], p[2]))];
        ASSERT_EQ(masks[k].test(u, v), belongs(rules[k], p[0], p[1], p[2], added));
      }
    }
  }
}

TEST(ColourClassifier, RefusesAnIntervalThatIsNotFinite) {
  EXPECT_THROW(make_rule({std::numeric_limits<double>::quiet_NaN(), 1.0, 0.0, 1.0, 0.0, 1.0}, 0),
               std::invalid_argument);
}

}  // namespace
}  // namespace markservo::mark_detector
