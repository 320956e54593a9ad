#include "services/stereo-camera/encoder.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "services/stereo-camera/pairs/side_by_side.hpp"

namespace markservo::stereo_camera {
namespace {

TEST(RawEncoding, IsRowByRowBlueFirst) {
  cv::Mat image(2, 2, CV_8UC3, cv::Scalar(0, 0, 0));
  image.at<cv::Vec3b>(0, 1) = {1, 2, 3};
  image.at<cv::Vec3b>(1, 0) = {4, 5, 6};
  std::vector<std::uint8_t> bytes;
  encode_raw(image, bytes);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0, 0, 0, 1, 2, 3, 4, 5, 6, 0, 0, 0}));
}

TEST(RawEncoding, OfAHalfOfAPictureHoldsThatHalfOnly) {
  cv::Mat image(2, 4, CV_8UC3, cv::Scalar::all(7));
  image.colRange(2, 4).setTo(cv::Scalar::all(9));
  const auto halves = split_side_by_side(image);
  ASSERT_TRUE(halves);
  std::vector<std::uint8_t> bytes;
  encode_raw(halves->left, bytes);
  EXPECT_EQ(bytes, std::vector<std::uint8_t>(12, 7));
  encode_raw(halves->right, bytes);
  EXPECT_EQ(bytes, std::vector<std::uint8_t>(12, 9));
}

TEST(SideBySide, NeedsAnEvenWidth) {
  EXPECT_FALSE(split_side_by_side(cv::Mat(2, 3, CV_8UC3)));
  EXPECT_FALSE(split_side_by_side(cv::Mat()));
}

TEST(JpegEncoding, KeepsSizeAndColour) {
  const cv::Mat image(48, 64, CV_8UC3, cv::Scalar(200, 60, 30));
  std::vector<std::uint8_t> bytes;
  encode_jpeg(image, 90, bytes);
  const cv::Mat decoded = cv::imdecode(bytes, cv::IMREAD_COLOR);
  ASSERT_EQ(decoded.size(), image.size());
  EXPECT_LE(cv::norm(decoded, image, cv::NORM_INF), 3.0);
}

TEST(Encoding, RefusesWhatIsNoColourPictureAndImpossibleQualities) {
  std::vector<std::uint8_t> bytes;
  EXPECT_THROW(encode_raw(cv::Mat(2, 2, CV_8UC1), bytes), std::invalid_argument);
  EXPECT_THROW(encode_raw(cv::Mat(), bytes), std::invalid_argument);
  EXPECT_THROW(encode_jpeg(cv::Mat(2, 2, CV_8UC3), 0, bytes), std::invalid_argument);
  EXPECT_THROW(encode_jpeg(cv::Mat(2, 2, CV_8UC3), 101, bytes), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::stereo_camera
