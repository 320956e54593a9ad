#include "services/mark-detector/learning/interval_fit.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>

namespace markservo::mark_detector {
namespace {

constexpr double kHue_deg = 200.0;
constexpr int kChromaMin = 14;
constexpr Limits kWidest{-20.0, -20.0, 0.3, -1.0, 0.1, -1.0};
constexpr Limits kNarrowest{-2.0, -2.0, 0.78, -0.82, 0.45, -0.55};

// 1 px of a thing, with a little noise.
class Things {
 public:
  void add(int count, double mark_share, double hue_deg, double saturation, double value, double chroma = 60.0) {
    for (int i = 0; i < count; ++i) {
      LearningPixel pixel;
      pixel.hue_deg = hue_deg + noise(1.0);
      pixel.saturation = saturation + noise(0.01);
      pixel.value = value + noise(0.01);
      pixel.chroma = chroma;
      pixel.mark_share = mark_share;
      pixels_.push_back(pixel);
    }
  }
  Limits fit() const { return fit_interval(pixels_, kHue_deg, kChromaMin, kWidest, kNarrowest); }

  // Of what passes the limits with the mark: px of both over px of either.
  double overlap(const Limits& limits) const {
    double both = 0.0;
    double either = 0.0;
    for (const LearningPixel& pixel : pixels_) {
      bool passes = pixel.chroma >= kChromaMin;
      for (std::size_t k = 0; k < kNumLimits; ++k) passes = passes && limited(pixel, k, kHue_deg) >= limits.at(k);
      both += passes ? pixel.mark_share : 0.0;
      either += passes ? 1.0 : pixel.mark_share;
    }
    return both / either;
  }

 private:
  double noise(double sigma) { return std::normal_distribution<double>(0.0, sigma)(random_); }

  std::mt19937 random_{5};
  std::vector<LearningPixel> pixels_;
};

TEST(IntervalFit, StaysAtItsWidestWhereNothingComesNear) {
  Things things;
  things.add(1000, 1.0, 200.0, 0.8, 0.5);
  things.add(5000, 0.0, 240.0, 0.8, 0.5);
  things.add(5000, 0.0, 200.0, 0.1, 0.5);
  EXPECT_EQ(things.fit(), kWidest);
  EXPECT_NEAR(things.overlap(kWidest), 1.0, 1e-12);
}

TEST(IntervalFit, PutsALimitBetweenTheMarkAndWhatIsAroundIt) {
  Things paler;
  paler.add(1000, 1.0, 200.0, 0.8, 0.5);
  paler.add(5000, 0.0, 200.0, 0.5, 0.5);
  const Limits by_saturation = paler.fit();
  EXPECT_NEAR(by_saturation[kSaturationLow], 0.65, 0.06);
  EXPECT_GT(paler.overlap(by_saturation), 0.98);
  EXPECT_EQ(by_saturation[kHueLow], kWidest[kHueLow]);
  EXPECT_EQ(by_saturation[kValueLow], kWidest[kValueLow]);

  Things bluer;
  bluer.add(1000, 1.0, 200.0, 0.8, 0.5);
  bluer.add(5000, 0.0, 212.0, 0.8, 0.5);
  const Limits by_hue = bluer.fit();
  EXPECT_NEAR(by_hue[kHueHigh], -6.0, 2.0);
  EXPECT_GT(bluer.overlap(by_hue), 0.98);
  EXPECT_EQ(by_hue[kHueLow], kWidest[kHueLow]);
}

TEST(IntervalFit, TellsByBrightnessOnlyWhatHueAndSaturationDoNot) {
  Things darker_and_paler;
  darker_and_paler.add(1000, 1.0, 200.0, 0.8, 0.5);
  darker_and_paler.add(5000, 0.0, 200.0, 0.5, 0.2);
  EXPECT_EQ(darker_and_paler.fit()[kValueLow], kWidest[kValueLow]);

  Things darker;
  darker.add(1000, 1.0, 200.0, 0.8, 0.5);
  darker.add(5000, 0.0, 200.0, 0.8, 0.2);
  const Limits fit = darker.fit();
  EXPECT_NEAR(fit[kValueLow], 0.35, 0.1);
  EXPECT_GT(darker.overlap(fit), 0.98);
}

TEST(IntervalFit, DoesNotCutTheMarkAwayForAThingOfItsOwnColour) {
  Things twins;
  twins.add(1000, 1.0, 200.0, 0.8, 0.5);
  twins.add(1000, 0.0, 200.0, 0.8, 0.5);
  EXPECT_EQ(twins.fit(), kWidest);
  EXPECT_NEAR(twins.overlap(kWidest), 0.5, 0.01);
}

TEST(IntervalFit, CountsPixelsWithoutChromaAsNeverPassing) {
  Things half_grey;
  half_grey.add(500, 1.0, 200.0, 0.8, 0.5);
  half_grey.add(500, 1.0, 200.0, 0.8, 0.5, kChromaMin - 1.0);
  EXPECT_NEAR(half_grey.overlap(half_grey.fit()), 0.5, 1e-12);
}

}  // namespace
}  // namespace markservo::mark_detector
