#include <gtest/gtest.h>

#include "services/camera-check/picture/picture_blur.hpp"
#include "services/camera-check/picture/picture_light.hpp"
#include "tests/unit/camera-check/scene_pair.hpp"

namespace markservo::camera_check {
namespace {

TEST(Light, IsToldByLevelsThatAFewPixelsDoNotDecide) {
  cv::Mat picture(100, 100, CV_8U, cv::Scalar(40));
  picture.rowRange(0, 4).setTo(255);  // a lamp
  const PictureLight light = light_of(picture);
  EXPECT_EQ(light.middle_level, 40.0);
  EXPECT_EQ(light.bright_level, 40.0);
  EXPECT_DOUBLE_EQ(light.blown_share, 0.04);
}

TEST(Light, OfAWhitePictureIsBlown) {
  EXPECT_DOUBLE_EQ(light_of(cv::Mat(10, 10, CV_8U, cv::Scalar(255))).blown_share, 1.0);
}

// A strong blur leaves few edges that its neighbours do not reach, and comes out up to a quarter too small.
TEST(Blur, IsTheLenssInPicturesOfAScene) {
  for (const double blur_px : {0.6, 1.2, 2.5, 4.0}) {
    for (const unsigned seed : {1U, 2U}) {
      const auto found = blur_of(grey_of(scene_pair(blur_px, seed).left));
      ASSERT_TRUE(found) << blur_px << " px, seed " << seed;
      EXPECT_NEAR(*found, blur_px, 0.15 + 0.25 * blur_px) << "seed " << seed;
    }
  }
}

TEST(Blur, DoesNotGrowWithTheNoise) {
  cv::Mat grey = grey_of(scene_pair(0.8).left);
  cv::Mat noise(grey.size(), CV_16S);
  cv::RNG(7).fill(noise, cv::RNG::NORMAL, 0.0, 8.0);
  cv::Mat noisy;
  cv::add(grey, noise, noisy, cv::noArray(), CV_8U);
  const auto found = blur_of(noisy);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 0.8, 0.4);
}

TEST(Blur, OfACameraThatMovesIsFoundAlthoughItIsSharpTheOtherWay) {
  cv::Mat moved;
  cv::blur(grey_of(scene_pair(0.6).left), moved, cv::Size(15, 1));
  const auto found = blur_of(moved);
  ASSERT_TRUE(found);
  EXPECT_GT(*found, 2.0);
}

TEST(Blur, IsUnknownWhereThereIsNothingToSee) {
  cv::Mat wall(480, 640, CV_8U);
  cv::RNG(1).fill(wall, cv::RNG::NORMAL, 128.0, 3.0);
  EXPECT_FALSE(blur_of(wall));
  EXPECT_FALSE(blur_of(cv::Mat(480, 640, CV_8U, cv::Scalar(0))));
}

}  // namespace
}  // namespace markservo::camera_check
