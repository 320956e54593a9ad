#include "services/mark-detector/blobs/majority_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "tests/unit/imaging/random_mask.hpp"

namespace markservo::mark_detector {
namespace {

using imaging::test::random_mask;

bool majority_at(const BitMask& mask, int u, int v) {
  int n = 0;
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      n += mask.test(std::clamp(u + du, 0, mask.width() - 1), std::clamp(v + dv, 0, mask.height() - 1)) ? 1 : 0;
    }
  }
  return n >= 5;
}

BitMask majority3(const BitMask& mask) {
  BitMask result;
  MajorityFilter().apply(mask, result);
  return result;
}

TEST(Majority, IsTheCountOfNineWithARepeatedBorder) {
  for (const int width : {1, 2, 63, 64, 65, 129}) {
    for (const int height : {1, 2, 9, 40}) {
      for (const double share : {0.005, 0.2, 0.5, 0.8}) {
        const BitMask mask = random_mask(width, height, share, static_cast<unsigned>(width + height));
        const BitMask clean = majority3(mask);
        std::int64_t expected = 0;
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

TEST(Majority, ForgetsTheMaskBefore) {
  MajorityFilter filter;
  BitMask result;
  filter.apply(random_mask(130, 20, 0.5, 1), result);
  const BitMask mask = random_mask(130, 20, 0.1, 2);
  filter.apply(mask, result);
  EXPECT_EQ(result, majority3(mask));
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
