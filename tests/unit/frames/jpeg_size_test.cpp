#include "common/frames/jpeg_size.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

namespace markservo::frames {
namespace {

using Bytes = std::vector<std::uint8_t>;

const Bytes kStart = {0xFF, 0xD8};
const Bytes kComment = {0xFF, 0xFE, 0x00, 0x04, 0xFF, 0xC0};  // holds a false marker
const Bytes kFrame = {0xFF, 0xC0, 0x00, 0x0B, 0x08, 0x01, 0xE0, 0x02, 0x80, 0x01, 0x01, 0x11, 0x00};  // 640 x 480

Bytes join(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

TEST(JpegSize, IsWhatTheEncoderWrote) {
  for (const int progressive : {0, 1}) {
    Bytes bytes;
    cv::imencode(".jpg", cv::Mat(48, 300, CV_8UC3, cv::Scalar(1, 2, 3)), bytes,
                 {cv::IMWRITE_JPEG_PROGRESSIVE, progressive});
    const auto size = jpeg_size(bytes);
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 300);
    EXPECT_EQ(size->height, 48);
  }
}

TEST(JpegSize, SkipsOtherSegmentsAndFillBytes) {
  const auto size = jpeg_size(join({kStart, kComment, {0xFF, 0xFF}, kFrame}));
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 640);
  EXPECT_EQ(size->height, 480);
}

TEST(JpegSize, ReadsTheLargestClaimWithoutDecodingIt) {
  Bytes huge = kFrame;
  huge[5] = huge[6] = huge[7] = huge[8] = 0xFF;
  const auto size = jpeg_size(join({kStart, huge}));
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 65535);
  EXPECT_EQ(size->height, 65535);
}

TEST(JpegSize, NoTruncatedHeaderHasOne) {
  const Bytes whole = join({kStart, kComment, kFrame});
  ASSERT_TRUE(jpeg_size(whole));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_FALSE(jpeg_size(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)))) << length;
  }
}

TEST(JpegSize, HostileHeadersHaveNone) {
  Bytes no_height = kFrame;
  no_height[5] = no_height[6] = 0;
  Bytes no_width = kFrame;
  no_width[7] = no_width[8] = 0;
  Bytes short_frame = kFrame;
  short_frame[3] = 6;
  const Bytes before_the_frame[] = {
      {0x00},                    // no marker
      {0xFF, 0xFE, 0x00, 0x00},  // a segment that ends before it begins
      {0xFF, 0xFE, 0x00, 0x01},
      {0xFF, 0xFE, 0xFF, 0xFF},                                      // one that ends behind the file
      {0xFF, 0xDA, 0x00, 0x08, 0x01, 0x01, 0x00, 0x00, 0x3F, 0x00},  // a scan
      {0xFF, 0xD9},                                                  // the end
      {0xFF, 0xD0},                                                  // a restart
      {0xFF, 0x00},                                                  // a stuffed byte
      {0xFF, 0xD8},                                                  // a second start
  };
  for (const Bytes& part : before_the_frame) EXPECT_FALSE(jpeg_size(join({kStart, part, kFrame})));
  EXPECT_FALSE(jpeg_size(join({kStart, no_height})));
  EXPECT_FALSE(jpeg_size(join({kStart, no_width})));
  EXPECT_FALSE(jpeg_size(join({kStart, short_frame})));
  EXPECT_FALSE(jpeg_size(kFrame));
  EXPECT_FALSE(jpeg_size(join({{0x89, 'P', 'N', 'G'}, kFrame})));
  EXPECT_FALSE(jpeg_size(join({kStart, Bytes(1000, 0xFF)})));
}

}  // namespace
}  // namespace markservo::frames
