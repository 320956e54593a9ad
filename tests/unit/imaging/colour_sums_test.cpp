// Every vector instruction set that this processor has gives the exact sums.

#include "common/imaging/colour_sums.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "tests/unit/vector_target.hpp"

namespace markservo::imaging {
namespace {

class VectorTarget : public test::VectorTargetTest {};

TEST_P(VectorTarget, SumsTheColoursOfTheChosenPixels) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> level(0, 255);
  for (const int width : {1, 5, 15, 16, 17, 63, 64, 65, 93, 130}) {
    for (const int row_step : {1, 2, 3}) {
      constexpr int kHeight = 7;
      const std::ptrdiff_t stride = 3 * width + 5;
      std::vector<std::uint8_t> image(static_cast<std::size_t>(stride * kHeight));
      for (std::uint8_t& value : image) value = static_cast<std::uint8_t>(level(random));
      BitMask chosen(width, kHeight);
      ColourSums expected;
      for (int v = 0; v < kHeight; ++v) {
        for (int u = 0; u < width; ++u) {
          if (v == 4 || level(random) < 100) continue;
          chosen.set(u, v, true);
          if (v % row_step != 0) continue;
          const std::uint8_t* p = &image[static_cast<std::size_t>(v * stride + 3 * u)];
          ++expected.count;
          for (std::size_t c = 0; c < 3; ++c) expected.first[c] += p[c];
          const int products[] = {p[0] * p[0], p[0] * p[1], p[0] * p[2], p[1] * p[1], p[1] * p[2], p[2] * p[2]};
          for (std::size_t c = 0; c < 6; ++c) expected.second[c] += products[c];
        }
      }
      ColourSums sums;
      add_colours(image.data(), stride, chosen, row_step, sums);
      EXPECT_EQ(sums.count, expected.count) << width;
      EXPECT_EQ(sums.first, expected.first) << width;
      EXPECT_EQ(sums.second, expected.second) << width;
    }
  }
}

TEST_P(VectorTarget, HoldsTheSumsOfALargeWhiteImage) {
  constexpr int kSide = 3000;
  const std::vector<std::uint8_t> white(std::size_t{3} * kSide * kSide, 255);
  BitMask all(kSide, kSide);
  for (int v = 0; v < kSide; ++v) all.set_run(v, 0, kSide);
  ColourSums sums;
  add_colours(white.data(), std::ptrdiff_t{3} * kSide, all, 1, sums);
  EXPECT_EQ(sums.count, std::int64_t{kSide} * kSide);
  EXPECT_EQ(sums.second[5], std::int64_t{255} * 255 * kSide * kSide);
}

TEST(ColourSums, TellMeanAndCovariance) {
  const std::vector<std::uint8_t> image = {10, 0, 0, 20, 4, 0};
  BitMask all(2, 1);
  all.set_run(0, 0, 2);
  ColourSums sums;
  add_colours(image.data(), 6, all, 1, sums);
  EXPECT_EQ(sums.mean(0), 15.0);
  EXPECT_EQ(sums.covariance(0, 0), 25.0);
  EXPECT_EQ(sums.covariance(1, 0), 10.0);
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, VectorTarget, test::every_vector_target(), test::vector_target_name);

}  // namespace
}  // namespace markservo::imaging
