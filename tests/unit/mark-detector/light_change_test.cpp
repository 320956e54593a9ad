#include "services/mark-detector/adaptation/light_change.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace markservo::mark_detector {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr double kSigma = 3.0;

// A wall of many levels under light of these gains, with noise; from column `covered_from` on something else stands
// before it.
class Wall {
 public:
  ImageView under(const Bgr& gains, unsigned seed, int covered_from = kWidth) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, kSigma);
    pixels_.clear();
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        const double level = u < covered_from ? 30.0 + 37.0 * ((7 * (u / 8) + 5 * (v / 8)) % 4) : 200.0;
        for (const double gain : gains) {
          pixels_.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(gain * level + noise(random)), 0L, 255L)));
        }
      }
    }
    return {pixels_.data(), kWidth, kHeight, 3 * kWidth};
  }

 private:
  std::vector<std::uint8_t> pixels_;
};

void expect_gains(const LightChange& change, const Bgr& gains, double share) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(change.gains[c] / gains[c], 1.0, share) << "channel " << c;
}

TEST(LightChange, IsOneInTheFirstFrameAndUnderTheSameLight) {
  Wall wall;
  LightSamples samples;
  const LightChange first = light_change(wall.under({1.0, 1.0, 1.0}, 1), {}, samples);
  EXPECT_FALSE(first.certain);
  expect_gains(first, {1.0, 1.0, 1.0}, 0.0);
  const LightChange second = light_change(wall.under({1.0, 1.0, 1.0}, 2), {}, samples);
  EXPECT_TRUE(second.certain);
  expect_gains(second, {1.0, 1.0, 1.0}, 0.01);
}

TEST(LightChange, TellsGainAndCastWhileMuchOfTheImageClips) {
  Wall wall;
  LightSamples samples;
  light_change(wall.under({1.0, 1.0, 1.0}, 1), {}, samples);
  const Bgr lamp{2.5 * 0.85, 2.5, 2.5 * 1.15};
  const LightChange on = light_change(wall.under(lamp, 2), {}, samples);
  EXPECT_TRUE(on.certain);
  expect_gains(on, lamp, 0.02);
  const LightChange off = light_change(wall.under({0.4, 0.4, 0.4}, 3), {}, samples);
  expect_gains(off, {0.4 / lamp[0], 0.4 / lamp[1], 0.4 / lamp[2]}, 0.05);
}

TEST(LightChange, DoesNotTakeAThingThatComesIntoViewForLight) {
  Wall wall;
  LightSamples samples;
  light_change(wall.under({1.0, 1.0, 1.0}, 1), {}, samples);
  expect_gains(light_change(wall.under({1.0, 1.0, 1.0}, 2, kWidth * 3 / 4), {}, samples), {1.0, 1.0, 1.0}, 0.03);
}

TEST(LightChange, SaysWhenTheSceneIsAnother) {
  Wall wall;
  LightSamples samples;
  light_change(wall.under({1.0, 1.0, 1.0}, 1), {}, samples);
  EXPECT_FALSE(light_change(wall.under({1.0, 1.0, 1.0}, 2, 0), {}, samples).certain);
  std::vector<std::uint8_t> small(3, 100);
  EXPECT_FALSE(light_change({small.data(), 1, 1, 3}, {}, samples).certain);
}

}  // namespace
}  // namespace markservo::mark_detector
