// Images that no camera should send: tiny, huge, of one colour, full of speckles. An answer, no crash, bounded memory
// and a bounded number of blobs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "services/mark-detector/mark_detector.hpp"
#include "tests/unit/allocation_count.hpp"

namespace markservo::mark_detector {
namespace {

struct Pixel {
  std::uint8_t b = 0;
  std::uint8_t g = 0;
  std::uint8_t r = 0;
};

constexpr Pixel kRed{40, 35, 190};
constexpr Pixel kGreen{50, 170, 40};
constexpr Pixel kBlue{190, 70, 30};
constexpr Pixel kYellow{30, 180, 200};
constexpr Pixel kGrey{120, 120, 120};

class Image {
 public:
  Image(int width, int height, const std::function<Pixel(int u, int v)>& colour) : width_(width), height_(height) {
    bytes_.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const Pixel pixel = colour(u, v);
        bytes_.insert(bytes_.end(), {pixel.b, pixel.g, pixel.r});
      }
    }
  }
  Image(int width, int height, const Pixel& colour) : Image(width, height, [colour](int, int) { return colour; }) {}

  ImageView view() const { return {bytes_.data(), width_, height_, 3 * std::ptrdiff_t{width_}}; }

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> bytes_;
};

robot::MarkDescription mark(const std::string& name, double hue_min, double hue_max,
                            robot::MarkSurface surface = robot::MarkSurface::kPlane) {
  robot::MarkDescription mark;
  mark.name = name;
  mark.size = 0.025;
  mark.surface = surface;
  mark.colour = {hue_min, hue_max, 0.4, 1.0, 0.2, 1.0};
  return mark;
}

// One of them free, so that both ways to choose among blobs are taken.
std::vector<robot::MarkDescription> marks() {
  return {mark("red", 345.0, 15.0), mark("green", 95.0, 150.0), mark("blue", 200.0, 245.0),
          mark("yellow", 40.0, 72.0, robot::MarkSurface::kFree)};
}

void expect_sane(const View& view, const ImageView& image) {
  if (!view.seen) {
    EXPECT_EQ(view.patch.scale, 0);
    return;
  }
  EXPECT_GE(view.shape.x, 0);
  EXPECT_GE(view.shape.y, 0);
  EXPECT_LE(view.shape.x + view.shape.width, image.width);
  EXPECT_LE(view.shape.y + view.shape.height, image.height);
  EXPECT_GT(view.shape.area, 0.0);
  EXPECT_LE(view.shape.area, static_cast<double>(view.region.width) * view.region.height);
  for (const double value : {view.shape.u, view.shape.v, view.shape.m_uu, view.shape.m_uv, view.shape.m_vv}) {
    EXPECT_TRUE(std::isfinite(value));
  }
  const PatchParameters limits;
  EXPECT_LE(view.patch.width, limits.limit);
  EXPECT_LE(view.patch.height, limits.limit);
  EXPECT_EQ(view.patch.bgr.size(), static_cast<std::size_t>(view.patch.width * view.patch.height * 3));
}

Output detect(const Image& left, const Image& right) {
  const Input input{left.view(), right.view(), geometry::StereoCamera{784.0, 784.0, 319.5, 319.5, 239.5, 0.065}};
  State state;
  const MarkDetector detector(marks(), {});
  detector.step(input, state);
  Output output = detector.step(input, state);  // again, with what is remembered
  EXPECT_EQ(output.marks.size(), 4U);
  for (const Finding& finding : output.marks) {
    SCOPED_TRACE(finding.name);
    expect_sane(finding.left, input.left);
    expect_sane(finding.right, input.right);
    EXPECT_LE(finding.left_blobs.blobs.size(), BlobParameters{}.max_blobs);
    EXPECT_LE(finding.right_blobs.blobs.size(), BlobParameters{}.max_blobs);
    EXPECT_EQ(finding.reason.empty(), finding.left.seen && finding.right.seen);
    EXPECT_GE(finding.separability, 0.0);
    EXPECT_LE(finding.separability, 1.0);
  }
  return output;
}

Output detect(const Image& image) {
  return detect(image, image);
}

int num_seen(const Output& output) {
  int seen = 0;
  for (const Finding& finding : output.marks) seen += finding.left.seen || finding.right.seen ? 1 : 0;
  return seen;
}

TEST(ExtremeImage, OfOnePixelShowsNoMark) {
  for (const Pixel& colour : {kRed, kGrey, Pixel{0, 0, 0}, Pixel{255, 255, 255}}) {
    EXPECT_EQ(num_seen(detect(Image(1, 1, colour))), 0);
  }
}

TEST(ExtremeImage, OfOneColourThatNoMarkHasShowsNone) {
  for (const auto& [width, height] :
       {std::pair{640, 480}, std::pair{4096, 3072}, std::pair{1, 4096}, std::pair{4096, 1}}) {
    for (const std::uint8_t level : {std::uint8_t{0}, std::uint8_t{120}, std::uint8_t{255}}) {
      EXPECT_EQ(num_seen(detect(Image(width, height, {level, level, level}))), 0) << width << " x " << height;
    }
  }
}

TEST(ExtremeImage, WhollyOfAMarksColourIsOneClippedMark) {
  for (const auto& [width, height] : {std::pair{64, 64}, std::pair{640, 480}, std::pair{4096, 3072}}) {
    const Image image(width, height, kRed);
    // From the same image twice no mark has a disparity; so one image alone.
    State state;
    const Output output = MarkDetector(marks(), {}).step({image.view(), {}, std::nullopt}, state);
    EXPECT_EQ(num_seen(output), 1);
    const View& red = output.marks[0].left;
    EXPECT_TRUE(red.clipped);
    EXPECT_EQ(red.shape.area, static_cast<double>(width) * height);
    EXPECT_NEAR(red.shape.u, 0.5 * (width - 1), 1e-6);
    EXPECT_NEAR(red.shape.v, 0.5 * (height - 1), 1e-6);
    EXPECT_NE(detect(image).marks[0].reason, "");
  }
}

TEST(ExtremeImage, OfOneRowOrColumnIsSearchedLikeAnyOther) {
  State state;
  const MarkDetector detector(marks(), {});
  for (const auto& [width, height] : {std::pair{4096, 1}, std::pair{1, 4096}}) {
    const Image image(width, height, [](int u, int v) { return u + v >= 100 && u + v < 400 ? kGreen : kGrey; });
    const View green = detector.step({image.view(), {}, std::nullopt}, state).marks[1].left;
    ASSERT_TRUE(green.seen) << width << " x " << height;
    EXPECT_NEAR(green.shape.u + green.shape.v, 249.5, 1.0);
    EXPECT_NEAR(green.shape.area, 300.0, 4.0);
    detect(image);
  }
}

TEST(ExtremeImage, FindsAMarkInAnyWidthAroundAWholeNumberOfWords) {
  for (const int words : {1, 2, 10}) {
    for (int off = -2; off <= 2; ++off) {
      const int width = 64 * words + off;
      // The mark ends two pixels before the right border, whatever the width.
      const Image left(width, 60, [width](int u, int v) {
        return u >= width - 22 && u < width - 2 && v >= 20 && v < 40 ? kBlue : kGrey;
      });
      const Image right(width, 60, [width](int u, int v) {
        return u >= width - 42 && u < width - 22 && v >= 20 && v < 40 ? kBlue : kGrey;
      });
      State state;
      const Output output = MarkDetector(marks(), {}).step({left.view(), right.view(), std::nullopt}, state);
      SCOPED_TRACE(width);
      EXPECT_EQ(num_seen(output), 1);
      const Finding& blue = output.marks[2];
      ASSERT_TRUE(blue.left.seen);
      EXPECT_NEAR(blue.left.shape.u, width - 12.5, 0.05);
      EXPECT_NEAR(blue.left.shape.v, 29.5, 0.05);
      EXPECT_FALSE(blue.left.clipped);
    }
  }
}

TEST(ExtremeImage, TellsThatABorderCutsAMark) {
  constexpr int kWidth = 200;
  constexpr int kHeight = 150;
  struct Cut {
    const char* border;
    int u;
    int v;
  };
  for (const Cut& cut : {Cut{"left", -15, 60}, Cut{"right", kWidth - 15, 60}, Cut{"top", 100, -15},
                         Cut{"bottom", 100, kHeight - 15}, Cut{"corner", -15, -15}}) {
    SCOPED_TRACE(cut.border);
    const Image image(kWidth, kHeight, [&cut](int u, int v) {
      return u >= cut.u && u < cut.u + 30 && v >= cut.v && v < cut.v + 30 ? kYellow : kGrey;
    });
    const Output output = detect(image);
    ASSERT_TRUE(output.marks[3].left.seen);
    EXPECT_TRUE(output.marks[3].left.clipped);
    const int cut_sides = cut.u < 0 && cut.v < 0 ? 2 : 1;
    EXPECT_NEAR(output.marks[3].left.shape.area, 900.0 / (1 << cut_sides), 8.0);
  }
}

Image all_colours_in_noise(int width, int height) {
  std::mt19937 random(7);
  return {width, height, [&random](int, int) {
            const Pixel colours[] = {kRed, kGreen, kBlue, kYellow};
            const auto bits = random();
            if (bits % 8 < 4) return colours[bits % 4];
            return Pixel{static_cast<std::uint8_t>(bits >> 8), static_cast<std::uint8_t>(bits >> 16),
                         static_cast<std::uint8_t>(bits >> 24)};
          }};
}

Image speckled(int width, int height, const Pixel& colour) {
  std::mt19937 random(3);
  return {width, height, [&](int, int) { return random() % 2 == 0 ? colour : kGrey; }};
}

Image checkered(int width, int height, const Pixel& colour, int period) {
  return {width, height, [&](int u, int v) { return (u / period + v / period) % 2 == 0 ? colour : kGrey; }};
}

// Islands that do not touch, each just large enough to be a mark.
Image islands(int width, int height, const Pixel& colour) {
  return {width, height, [&](int u, int v) { return u % 12 < 9 && v % 12 < 9 ? colour : kGrey; }};
}

TEST(ExtremeImage, FullOfSpecklesGivesAnAnswer) {
  detect(all_colours_in_noise(640, 480));
  for (const Pixel& colour : {kRed, kYellow}) {  // a plane, and a free one, which takes all of its colour
    detect(speckled(640, 480, colour));
    for (const int period : {1, 2, 3, 8, 31}) detect(checkered(640, 480, colour, period));
  }
}

TEST(ExtremeImage, KeepsNoMoreBlobsThanItsLimitAndTellsOfTheLargest) {
  const Output output = detect(islands(1200, 900, kRed), islands(1200, 900, kRed));
  EXPECT_EQ(output.marks[0].left_blobs.blobs.size(), BlobParameters{}.max_blobs) << "of 7500";
  EXPECT_GE(output.marks[0].left_blobs.largest_area, 60);
}

// The image itself, 36 MiB a side, is the caller's.
class HugeImage : public ::testing::TestWithParam<int> {
 protected:
  static constexpr int kWidth = 4096;
  static constexpr int kHeight = 3072;
  static constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;

  static Image make(int kind) {
    switch (kind) {
      case 0:
        return {kWidth, kHeight, kRed};
      case 1:
        return speckled(kWidth, kHeight, kRed);
      case 2:
        return speckled(kWidth, kHeight, kYellow);
      case 3:
        return checkered(kWidth, kHeight, kRed, 2);
      case 4:
        return islands(kWidth, kHeight, kYellow);
      default:
        return all_colours_in_noise(kWidth, kHeight);
    }
  }
};

TEST_P(HugeImage, TakesMemoryInProportionToItsPixels) {
  const Image image = make(GetParam());
  const Input input{image.view(), {}, std::nullopt};
  const MarkDetector detector(marks(), {});
  State state;
  Output output;
  const std::size_t peak = test::peak_bytes([&] { output = detector.step(input, state); });
  RecordProperty("bytes_per_pixel", std::to_string(static_cast<double>(peak) / kPixels));
  // Masks are half a byte a pixel; runs of 12 bytes and their labels at every other pixel are the worst.
  EXPECT_LT(peak, 32 * kPixels);
  output = {};
  const std::size_t again = test::peak_bytes([&] { detector.step(input, state); });
  EXPECT_LE(again, peak) << "memory grows from frame to frame";
}

INSTANTIATE_TEST_SUITE_P(OneColourSpecklesChecksIslandsNoise, HugeImage, ::testing::Range(0, 6));

}  // namespace
}  // namespace markservo::mark_detector
