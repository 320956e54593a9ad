#include "common/frames/jpeg_decoder.hpp"

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace markservo::frames {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Colours that change along both axes, with an edge.
cv::Mat scene(cv::Size size) {
  cv::Mat image(size, CV_8UC3);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      image.at<cv::Vec3b>(v, u) = {static_cast<std::uint8_t>(3 * u), static_cast<std::uint8_t>(2 * v),
                                   static_cast<std::uint8_t>(u > size.width / 2 ? 220 : 30)};
    }
  }
  return image;
}

Bytes jpeg_of(const cv::Mat& image, const std::vector<int>& parameters = {}) {
  Bytes bytes;
  cv::imencode(".jpg", image, bytes, parameters);
  return bytes;
}

// Of one colour, in those of print, as some printers' and editors' files are.
Bytes cmyk_jpeg(cv::Size size) {
  const Bytes pixels(static_cast<std::size_t>(4 * size.area()), 200);
  unsigned char* data = nullptr;
  unsigned long length = 0;
  const tjhandle compressor = tjInitCompress();
  EXPECT_EQ(
      tjCompress2(compressor, pixels.data(), size.width, 0, size.height, TJPF_CMYK, &data, &length, TJSAMP_444, 90, 0),
      0);
  Bytes bytes(data, data + length);
  tjFree(data);
  tjDestroy(compressor);
  return bytes;
}

// Says that the camera lay on its side: an EXIF segment with orientation 6 (turn by 90 degrees).
Bytes lying(Bytes jpeg) {
  const Bytes exif{0xFF, 0xE1, 0, 34, 'E', 'x', 'i', 'f', 0, 0, 'M', 'M', 0, 42, 0, 0, 0, 8,
                   0,    1,    1, 18, 0,   3,   0,   0,   0, 1, 0,   6,   0, 0,  0, 0, 0, 0};
  jpeg.insert(jpeg.begin() + 2, exif.begin(), exif.end());
  return jpeg;
}

int most_different(const cv::Mat& a, const cv::Mat& b) {
  return static_cast<int>(cv::norm(a, b, cv::NORM_INF));
}

TEST(JpegDecoder, GivesThePixelsThatOpenCvDoes) {
  JpegDecoder decoder;
  cv::Mat grey;
  cv::cvtColor(scene({75, 49}), grey, cv::COLOR_BGR2GRAY);
  for (const Bytes& bytes :
       {jpeg_of(scene({75, 49})), jpeg_of(scene({75, 49}), {cv::IMWRITE_JPEG_PROGRESSIVE, 1}), jpeg_of(grey)}) {
    const cv::Mat unpacked = decoder.unpack(bytes, {75, 49});
    ASSERT_EQ(unpacked.size(), cv::Size(75, 49));
    ASSERT_EQ(unpacked.type(), CV_8UC3);
    EXPECT_EQ(most_different(unpacked, cv::imdecode(bytes, cv::IMREAD_COLOR)), 0);
  }
}

TEST(JpegDecoder, TakesPicturesOfChangingSizes) {
  JpegDecoder decoder;
  for (const cv::Size size : {cv::Size(64, 48), cv::Size(1, 1), cv::Size(320, 17), cv::Size(64, 48)}) {
    const Bytes bytes = jpeg_of(scene(size));
    EXPECT_EQ(most_different(decoder.unpack(bytes, size), cv::imdecode(bytes, cv::IMREAD_COLOR)), 0);
  }
}

TEST(JpegDecoder, GivesPicturesAsTheSensorSawThemInAnyColours) {
  JpegDecoder decoder;
  const Bytes print = lying(cmyk_jpeg({64, 48}));
  ASSERT_EQ(cv::imdecode(print, cv::IMREAD_COLOR).size(), cv::Size(48, 64)) << "no turn is stated: this proves nothing";
  EXPECT_EQ(decoder.unpack(print, {64, 48}).size(), cv::Size(64, 48));
  EXPECT_TRUE(decoder.unpack(print, {48, 64}).empty());
  EXPECT_EQ(decoder.unpack(lying(jpeg_of(scene({64, 48}))), {64, 48}).size(), cv::Size(64, 48));
}

TEST(JpegDecoder, RefusesWhatIsNone) {
  JpegDecoder decoder;
  EXPECT_TRUE(decoder.unpack({}, {64, 48}).empty());
  EXPECT_TRUE(decoder.unpack({0xFF, 0xD8, 0xFF, 0x00}, {64, 48}).empty());
  EXPECT_TRUE(decoder.unpack(Bytes(1000, 'x'), {64, 48}).empty());
  Bytes headless = jpeg_of(scene({64, 48}));
  headless.resize(40);
  EXPECT_TRUE(decoder.unpack(headless, {64, 48}).empty());
}

TEST(JpegDecoder, RefusesAnotherSizeThanAsked) {
  JpegDecoder decoder;
  const Bytes bytes = jpeg_of(scene({64, 48}));
  EXPECT_TRUE(decoder.unpack(bytes, {32, 24}).empty()) << "it could scale, but shall not";
  EXPECT_TRUE(decoder.unpack(bytes, {48, 64}).empty());
  EXPECT_FALSE(decoder.unpack(bytes, {64, 48}).empty());
}

TEST(JpegDecoder, ShowsNothingOfThePictureBeforeWhereAFileEndsTooEarly) {
  JpegDecoder decoder;
  decoder.unpack(jpeg_of(cv::Mat(480, 640, CV_8UC3, cv::Scalar(255, 255, 255))), {640, 480});
  const Bytes whole = jpeg_of(scene({640, 480}));
  const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2));
  const cv::Mat unpacked = decoder.unpack(cut, {640, 480});
  ASSERT_FALSE(unpacked.empty());
  const cv::Mat expected = cv::imdecode(whole, cv::IMREAD_COLOR);
  EXPECT_EQ(most_different(unpacked.rowRange(0, 200), expected.rowRange(0, 200)), 0);
  JpegDecoder other;
  EXPECT_EQ(most_different(unpacked, other.unpack(cut, {640, 480})), 0);
}

}  // namespace
}  // namespace markservo::frames
