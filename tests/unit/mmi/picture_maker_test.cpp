#include "services/mmi/pictures/picture_maker.hpp"

#include <gtest/gtest.h>

#include <markservo/StereoFrame.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/unit/mmi/frame_messages.hpp"

namespace markservo::mmi {
namespace {

std::shared_ptr<Frame> frame_of(const std::vector<std::uint8_t>& bytes) {
  auto frame = std::make_shared<Frame>();
  frame->session = 41;
  frame->seq = 1;
  frame->bytes = std::make_shared<const std::vector<std::uint8_t>>(bytes);
  return frame;
}

StereoFrame decoded(const std::vector<std::uint8_t>& bytes) {
  StereoFrame frame;
  frame.decode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return frame;
}

cv::Mat read(const std::string& jpeg) {
  return cv::imdecode(std::vector<std::uint8_t>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
}

TEST(PictureMaker, MakesJpegFilesOfRawFrames) {
  PictureMaker maker;
  const auto pair = maker.jpegs(frame_of(FrameMessages().frame()));
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->width, FrameMessages::kWidth);
  const cv::Mat left = read(pair->left);
  const cv::Mat right = read(pair->right);
  ASSERT_EQ(left.size(), cv::Size(FrameMessages::kWidth, FrameMessages::kHeight));
  EXPECT_NEAR(left.at<cv::Vec3b>(8, 16)[0], 200, 2);
  EXPECT_NEAR(right.at<cv::Vec3b>(8, 16)[2], 50, 2);
}

TEST(PictureMaker, PassesJpegFilesAsTheyAre) {
  StereoFrame frame = decoded(FrameMessages().frame());
  frame.encoding = StereoFrame::ENCODING_JPEG;
  frame.left = {1, 2, 3};
  frame.right = {4};
  frame.left_size = 3;
  frame.right_size = 1;
  PictureMaker maker;
  const auto pair = maker.jpegs(frame_of(test::encoded(frame)));
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->left, "\1\2\3");
  EXPECT_EQ(pair->right, "\4");
}

TEST(PictureMaker, MakesNothingOfFramesThatAreNone) {
  PictureMaker maker;
  EXPECT_FALSE(maker.jpegs(frame_of({1, 2, 3})));
  StereoFrame frame = decoded(FrameMessages().frame());
  frame.width = 1 << 20;
  EXPECT_FALSE(maker.jpegs(frame_of(test::encoded(frame))));
  frame = decoded(FrameMessages().frame());
  frame.encoding = 9;
  EXPECT_FALSE(maker.jpegs(frame_of(test::encoded(frame))));
}

TEST(PictureMessage, HasItsHeaderAndBothFiles) {
  auto frame = frame_of(FrameMessages().frame());
  frame->parts[static_cast<std::size_t>(FramePart::kPose)] =
      std::make_shared<const std::vector<std::uint8_t>>(FrameMessages().answers()[2].second);
  PictureMaker maker;
  const auto made = maker.made(frame);
  ASSERT_TRUE(made);
  const std::string message = picture_message(*made, 5);
  const auto byte = [&message](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(message[i]));
  };
  const std::size_t length = byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
  const auto header = nlohmann::json::parse(message.substr(4, length));
  EXPECT_EQ(header["number"], 5);
  EXPECT_EQ(header["frame_session"], "41");
  EXPECT_EQ(header["pose"]["frame_seq"], "1");
  EXPECT_TRUE(header["detection"].is_null());
  const std::size_t left = header["left_size"];
  const std::size_t right = header["right_size"];
  EXPECT_EQ(message.size(), 4 + length + left + right);
  EXPECT_EQ(message.substr(4 + length, left), made->pair->left);
}

TEST(PictureMaker, MakesAPictureAnewWhenAnAnswerHasCome) {
  auto frame = frame_of(FrameMessages().frame());
  PictureMaker maker;
  const auto before = maker.made(frame);
  EXPECT_EQ(maker.made(frame), before);
  frame->parts[0] = std::make_shared<const std::vector<std::uint8_t>>(FrameMessages().answers()[0].second);
  const auto after = maker.made(frame);
  EXPECT_NE(after, before);
  EXPECT_EQ(after->pair, before->pair);
}

}  // namespace
}  // namespace markservo::mmi
