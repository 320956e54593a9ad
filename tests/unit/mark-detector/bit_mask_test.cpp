#include "services/mark-detector/bit_mask.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace markservo::mark_detector {
namespace {

BitMask random_mask(int width, int height, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution set(share);
  BitMask mask(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) mask.set(u, v, set(random));
  }
  return mask;
}

bool majority_at(const BitMask& mask, int u, int v) {
  int n = 0;
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      n += mask.test(std::clamp(u + du, 0, mask.width() - 1), std::clamp(v + dv, 0, mask.height() - 1)) ? 1 : 0;
    }
  }
  return n >= 5;
}

TEST(BitMask, KeepsWhatWasSetAtAnyWidth) {
  for (const int width : {1, 7, 8, 63, 64, 65, 130}) {
    BitMask mask(width, 2);
    for (int u = 0; u < width; ++u) mask.set(u, 1, u % 3 == 0);
    for (int u = 0; u < width; ++u) {
      EXPECT_FALSE(mask.test(u, 0));
      EXPECT_EQ(mask.test(u, 1), u % 3 == 0) << width << " " << u;
    }
    EXPECT_EQ(mask.count(), (width + 2) / 3);
  }
}

TEST(BitMask, SetsRunsAcrossWords) {
  BitMask mask(200, 1);
  mask.set_run(0, 60, 131);
  EXPECT_EQ(mask.count(), 71);
  EXPECT_FALSE(mask.test(59, 0));
  EXPECT_TRUE(mask.test(60, 0));
  EXPECT_TRUE(mask.test(130, 0));
  EXPECT_FALSE(mask.test(131, 0));
}

TEST(Majority, IsTheCountOfNineWithARepeatedBorder) {
  for (const int width : {1, 2, 63, 64, 65, 129}) {
    for (const int height : {1, 2, 9}) {
      for (const double share : {0.2, 0.5, 0.8}) {
        const BitMask mask = random_mask(width, height, share, static_cast<unsigned>(width + height));
        const BitMask clean = majority3(mask);
        int64_t expected = 0;
        for (int v = 0; v < height; ++v) {
          for (int u = 0; u < width; ++u) {
            ASSERT_EQ(clean.test(u, v), majority_at(mask, u, v)) << width << " x " << height << " at " << u << " " << v;
            expected += majority_at(mask, u, v) ? 1 : 0;
          }
        }
        EXPECT_EQ(clean.count(), expected) << "bits beyond the width";
      }
    }
  }
}

TEST(Majority, TakesLonePixelsAwayAndFillsSingleHoles) {
  BitMask mask(40, 40);
  mask.set_run(3, 5, 6);
  for (int v = 10; v < 30; ++v) mask.set_run(v, 10, 30);
  BitMask whole = mask;
  BitMask holed(40, 40);
  holed.set_run(3, 5, 6);
  for (int v = 10; v < 30; ++v) {
    holed.set_run(v, 10, v == 20 ? 20 : 30);
    if (v == 20) holed.set_run(v, 21, 30);
  }
  EXPECT_FALSE(majority3(holed).test(5, 3));
  EXPECT_TRUE(majority3(holed).test(20, 20));
  EXPECT_EQ(majority3(holed), majority3(whole));
}

}  // namespace
}  // namespace markservo::mark_detector
