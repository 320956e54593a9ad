#include "services/mark-detector/colour/luma_equalisation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <random>

#include "services/mark-detector/picture/picture.hpp"

namespace markservo::mark_detector {
namespace {

cv::Mat random_image(int width, int height, double mean, double sigma, int seed) {
  cv::Mat image(height, width, CV_8UC3);
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(image, cv::RNG::NORMAL, cv::Scalar::all(mean), cv::Scalar::all(sigma));
  return image;
}

LumaShift shift_of(const cv::Mat& image) {
  LumaHistogram histogram{};
  accumulate(view_of(image), histogram);
  return equalising_shift(histogram);
}

TEST(LumaEqualisation, IsOpenCvsToTheLastLevel) {
  for (int seed = 1; seed <= 6; ++seed) {
    const cv::Mat image = random_image(97 + seed, 61, 20.0 * seed, 10.0 * seed, seed);
    cv::Mat ycrcb;
    cv::cvtColor(image, ycrcb, cv::COLOR_BGR2YCrCb);
    cv::Mat y;
    cv::extractChannel(ycrcb, y, 0);
    cv::Mat equalised;
    cv::equalizeHist(y, equalised);
    const LumaShift shift = shift_of(image);
    for (int v = 0; v < image.rows; ++v) {
      for (int u = 0; u < image.cols; ++u) {
        const auto& p = image.at<cv::Vec3b>(v, u);
        const int own = luma(p[0], p[1], p[2]);
        ASSERT_EQ(own, y.at<std::uint8_t>(v, u));
        ASSERT_EQ(own + shift[static_cast<std::size_t>(own)], equalised.at<std::uint8_t>(v, u)) << seed;
      }
    }
  }
}

TEST(LumaEqualisation, LeavesAnImageOfOneLevelAlone) {
  EXPECT_EQ(shift_of(cv::Mat(5, 7, CV_8UC3, cv::Scalar::all(0))), no_shift());
  EXPECT_EQ(shift_of(cv::Mat(5, 7, CV_8UC3, cv::Scalar::all(255))), no_shift());
  EXPECT_EQ(equalising_shift(LumaHistogram{}), no_shift());
}

TEST(LumaEqualisation, BrightensADarkImage) {
  const LumaShift shift = shift_of(random_image(64, 64, 12.0, 4.0, 3));
  EXPECT_GT(12 + shift[12], 90);
}

// Black cloth of 12 levels over most of the picture, things of up to 200 on the rest.
LumaHistogram mostly_black_cloth() {
  LumaHistogram histogram{};
  for (std::size_t level = 6; level < 18; ++level) histogram[level] = 1000;
  for (std::size_t level = 18; level < 200; ++level) histogram[level] = 40;
  return histogram;
}

TEST(LumaEqualisation, LeavesBlackClothBlackWhereMostOfAPictureIsDark) {
  const LumaShift shift = equalising_shift(mostly_black_cloth());
  EXPECT_GT(12 + shift[12], 80);
  EXPECT_LT(12 + against_darkness(shift)[12], 0.15 * 255.0);
}

TEST(LumaEqualisation, AgainstDarknessNeverDarkensAndLiftsNothingFurtherThanItsBound) {
  const LumaShift shift = equalising_shift(mostly_black_cloth());
  const LumaShift brightening = against_darkness(shift);
  for (std::size_t level = 0; level < shift.size(); ++level) {
    EXPECT_GE(brightening[level], 0);
    EXPECT_LE(brightening[level], (kGreatestLift - 1.0) * double(level));
    EXPECT_LE(brightening[level], std::max<int>(0, shift[level]));
  }
}

TEST(LumaEqualisation, AgainstDarknessMakesGoodForTwoFifthsOfTheLight) {
  LumaHistogram bright{};
  LumaHistogram dim{};
  for (std::size_t level = 10; level < 250; ++level) bright[level] = 10;
  for (std::size_t level = 4; level < 100; ++level) dim[level] = 25;
  for (const std::size_t level : {50, 100, 200}) {
    const std::size_t dimmed = level * 2 / 5;
    const int restored = static_cast<int>(dimmed) + against_darkness(equalising_shift(dim))[dimmed];
    EXPECT_NEAR(restored, static_cast<int>(level) + equalising_shift(bright)[level], 4) << level;
  }
}

}  // namespace
}  // namespace markservo::mark_detector
