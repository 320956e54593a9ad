#include "common/frames/frame_side.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

namespace markservo::frames {
namespace {

StereoFrame frame_of(std::int8_t encoding) {
  StereoFrame frame{};
  frame.width = 6;
  frame.height = 4;
  frame.encoding = encoding;
  return frame;
}

std::string objection(const StereoFrame& frame, const std::vector<std::uint8_t>& side) {
  JpegDecoder decoder;
  try {
    picture_of(frame, side, "left", decoder);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(FrameSide, IsNotCopiedWhereItIsRaw) {
  const std::vector<std::uint8_t> side(std::size_t{6} * 4 * 3, 7);
  JpegDecoder decoder;
  const cv::Mat picture = picture_of(frame_of(StereoFrame::ENCODING_BGR8), side, "left", decoder);
  EXPECT_EQ(picture.size(), cv::Size(6, 4));
  EXPECT_EQ(picture.data, side.data());
}

TEST(FrameSide, IsUnpackedWhereItIsAJpeg) {
  std::vector<std::uint8_t> side;
  cv::imencode(".jpg", cv::Mat(4, 6, CV_8UC3, cv::Scalar(80, 80, 80)), side);
  JpegDecoder decoder;
  const cv::Mat picture = picture_of(frame_of(StereoFrame::ENCODING_JPEG), side, "left", decoder);
  EXPECT_EQ(picture.size(), cv::Size(6, 4));
  EXPECT_EQ(picture.at<cv::Vec3b>(2, 3), cv::Vec3b(80, 80, 80));
}

TEST(FrameSide, ThatIsNoJpegOfTheFramesSizeIsToldByItsName) {
  std::vector<std::uint8_t> other;
  cv::imencode(".jpg", cv::Mat(5, 6, CV_8UC3, cv::Scalar(80, 80, 80)), other);
  const StereoFrame frame = frame_of(StereoFrame::ENCODING_JPEG);
  EXPECT_EQ(objection(frame, other), "left's JPEG is 6 x 5 px; allowed: the frame's 6 x 4 px");
  EXPECT_EQ(objection(frame, {0xFF, 0xD8, 0xFF, 0x00}), "left is no JPEG that can be read");
  EXPECT_EQ(objection(frame, {}), "left is no JPEG that can be read");
}

}  // namespace
}  // namespace markservo::frames
