#include "services/simulator/cameras/image_effects.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace markservo::simulator {
namespace {

cv::Mat grey(int level) {
  return {480, 640, CV_8UC3, cv::Scalar::all(level)};
}

ImageEffects noise_of(double sigma) {
  ImageEffects effects;
  effects.noise_sigma = sigma;
  return effects;
}

cv::Mat with_effects(const ImageEffects& effects, std::uint64_t seed, cv::Mat image) {
  apply_effects(effects, seed, image);
  return image;
}

double difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF);
}

TEST(ImageEffects, NoEffectsChangeNothing) {
  EXPECT_EQ(difference(with_effects({}, 1, grey(100)), grey(100)), 0.0);
}

TEST(ImageEffects, NoiseHasTheGivenDeviationAndNoBias) {
  for (const double sigma : {0.5, 3.0, 10.0}) {
    const cv::Mat image = with_effects(noise_of(sigma), 1, grey(128));
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(image, mean, deviation);
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(mean[channel], 128.0, 0.05 * sigma);
      // Rounding to whole levels adds a variance of 1/12.
      EXPECT_NEAR(deviation[channel], std::sqrt(sigma * sigma + 1.0 / 12.0), 0.02 * sigma);
    }
  }
}

TEST(ImageEffects, NoiseIsTheSameForTheSameSeedOnly) {
  const cv::Mat first = with_effects(noise_of(3.0), 1, grey(128));
  EXPECT_EQ(difference(with_effects(noise_of(3.0), 1, grey(128)), first), 0.0);
  EXPECT_GT(difference(with_effects(noise_of(3.0), 2, grey(128)), first), 0.0);
}

TEST(ImageEffects, NeighboursAndChannelsAreIndependent) {
  cv::Mat image = with_effects(noise_of(3.0), 1, grey(128));
  cv::Mat1f values;
  image.reshape(1, 1).convertTo(values, CV_32F);
  values -= 128.0F;
  for (const int lag : {1, 2, 3, 5, 15, 1920}) {
    const int count = values.cols - lag;
    const double correlation = values.colRange(0, count).dot(values.colRange(lag, lag + count)) / count / 9.0;
    EXPECT_NEAR(correlation, 0.0, 0.006) << "lag " << lag;
  }
}

TEST(ImageEffects, NoiseClipsAtBlackAndWhite) {
  double min = 0.0;
  double max = 0.0;
  cv::minMaxLoc(with_effects(noise_of(50.0), 1, grey(250)).reshape(1), &min, &max);
  EXPECT_EQ(max, 255.0);
}

TEST(ImageEffects, EverySideOfEveryFrameHasItsOwnNoise) {
  EXPECT_NE(noise_seeds(1, 1).left, noise_seeds(1, 1).right);
  EXPECT_NE(noise_seeds(1, 1).left, noise_seeds(1, 2).left);
  EXPECT_NE(noise_seeds(1, 1).left, noise_seeds(2, 1).left);
}

TEST(ImageEffects, GainsScaleTheirOwnChannel) {
  ImageEffects effects;
  effects.gain_red = 2.0;
  effects.gain_green = 0.5;
  const cv::Mat image = with_effects(effects, 1, grey(100));
  EXPECT_EQ(image.at<cv::Vec3b>(10, 10), cv::Vec3b(100, 50, 200));
}

TEST(ImageEffects, BlurSpreadsAPoint) {
  cv::Mat image = grey(0);
  image.at<cv::Vec3b>(240, 320) = cv::Vec3b(255, 255, 255);
  ImageEffects effects;
  effects.blur_px = 1.0;
  apply_effects(effects, 1, image);
  EXPECT_NEAR(image.at<cv::Vec3b>(240, 320)[0], 255.0 / (2.0 * 3.14159), 3.0);
  EXPECT_GT(image.at<cv::Vec3b>(240, 321)[0], 15);
}

}  // namespace
}  // namespace markservo::simulator
