#include "common/imaging/bit_mask.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "tests/unit/imaging/random_mask.hpp"

namespace markservo::imaging {
namespace {

using imaging::test::random_mask;

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

// Is any (or are all) of the pixels within `reach` set?
bool around(const BitMask& mask, int u, int v, int reach, bool all) {
  for (int dv = -reach; dv <= reach; ++dv) {
    for (int du = -reach; du <= reach; ++du) {
      const int x = u + du;
      const int y = v + dv;
      const bool inside = x >= 0 && y >= 0 && x < mask.width() && y < mask.height();
      if ((inside && mask.test(x, y)) != all) return !all;
    }
  }
  return all;
}

TEST(BitMask, GrowsAndShrinksByASquare) {
  for (const int width : {1, 5, 63, 64, 65, 129, 200}) {
    for (const int height : {1, 2, 9, 40}) {
      for (const int reach : {0, 1, 2, 3, 5, 8}) {
        const BitMask sparse = random_mask(width, height, 0.02, static_cast<unsigned>(width + height));
        const BitMask dense = random_mask(width, height, 0.98, static_cast<unsigned>(width + height));
        BitMask grown;
        BitMask shrunk;
        dilate(sparse, reach, grown);
        erode(dense, reach, shrunk);
        const BitMask specks = random_mask(width, height, 0.003, static_cast<unsigned>(width + height));
        BitMask grown_specks;
        dilate(specks, reach, grown_specks);
        for (int v = 0; v < height; ++v) {
          for (int u = 0; u < width; ++u) {
            ASSERT_EQ(grown.test(u, v), around(sparse, u, v, reach, false))
                << width << " " << reach << " " << u << " " << v;
            ASSERT_EQ(grown_specks.test(u, v), around(specks, u, v, reach, false)) << width << " " << u << " " << v;
            ASSERT_FALSE(grown_specks.surely_empty(v) && grown_specks.test(u, v));
            ASSERT_FALSE(shrunk.surely_empty(v) && shrunk.test(u, v));
            ASSERT_EQ(shrunk.test(u, v), around(dense, u, v, reach, true))
                << width << " " << reach << " " << u << " " << v;
          }
        }
        EXPECT_LE(grown.count(), std::int64_t{width} * height) << "bits beyond the width";
      }
    }
  }
}

TEST(BitMask, TurnsRowsIntoColumns) {
  for (const int width : {1, 63, 64, 65, 130}) {
    for (const int height : {1, 64, 70, 129}) {
      const BitMask mask = random_mask(width, height, 0.4, static_cast<unsigned>(width * height));
      BitMask turned;
      transpose(mask, turned);
      ASSERT_EQ(turned.count(), mask.count());
      for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) ASSERT_EQ(turned.test(v, u), mask.test(u, v)) << width << " " << height;
      }
    }
  }
}

TEST(BitMask, ComplementIsAllElse) {
  BitMask mask = random_mask(70, 5, 0.3, 3);
  const std::int64_t before = mask.count();
  complement(mask);
  EXPECT_EQ(mask.count(), 350 - before);
}

TEST(BitMask, LessAnotherIsWhatTheOtherDoesNotHave) {
  const BitMask mask = random_mask(70, 5, 0.5, 3);
  const BitMask other = random_mask(70, 5, 0.5, 4);
  BitMask rest(3, 3);
  subtract(mask, other, rest);
  for (int v = 0; v < 5; ++v) {
    for (int u = 0; u < 70; ++u) EXPECT_EQ(rest.test(u, v), mask.test(u, v) && !other.test(u, v));
  }
  BitMask in_place = other;
  subtract(mask, in_place, in_place);
  EXPECT_EQ(in_place, rest);
}

TEST(BitMask, IsClearAfterAReset) {
  BitMask mask = random_mask(70, 5, 0.3, 3);
  mask.reset(70, 5);
  EXPECT_EQ(mask, BitMask(70, 5));
  EXPECT_TRUE(mask.surely_empty(2));
  mask.set(3, 2, true);
  EXPECT_FALSE(mask.surely_empty(2));
  mask.reset(10, 2);
  EXPECT_EQ(mask.count(), 0);
}

}  // namespace
}  // namespace markservo::imaging
