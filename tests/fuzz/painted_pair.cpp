#include "tests/fuzz/painted_pair.hpp"

#include <algorithm>
#include <array>
#include <random>

namespace markservo::fuzz {
namespace {

using Colour = std::array<std::uint8_t, 3>;  // blue, green, red

enum class Pattern { kPlain, kCheckerboard, kSpeckles, kPrint, kNoise };

struct Stroke {
  Pattern pattern = Pattern::kPlain;
  int x = 0;  // px, in the left image
  int y = 0;
  int width = 0;
  int height = 0;
  int disparity = 0;  // px
  int period = 1;     // px, of checkerboards
  unsigned seed = 0;  // of speckles and noise; their share is in `density`
  int density = 0;    // of 255
  Colour colour{};
};

Colour take_colour(FuzzedDataProvider& data) {
  // The default robot's marks, then what is no colour.
  constexpr std::array<Colour, 7> kUsual = {
      {{40, 35, 190}, {50, 170, 40}, {190, 70, 30}, {30, 180, 200}, {0, 0, 0}, {255, 255, 255}, {120, 120, 120}}};
  if (data.ConsumeIntegralInRange(0, 3) < 3) return data.PickValueInArray(kUsual);
  return {data.ConsumeIntegral<std::uint8_t>(), data.ConsumeIntegral<std::uint8_t>(),
          data.ConsumeIntegral<std::uint8_t>()};
}

Stroke take_stroke(FuzzedDataProvider& data, int width, int height) {
  Stroke stroke;
  stroke.pattern = static_cast<Pattern>(data.ConsumeIntegralInRange(0, 4));
  stroke.colour = take_colour(data);
  stroke.x = data.ConsumeIntegralInRange(-8, width);
  stroke.y = data.ConsumeIntegralInRange(-8, height);
  stroke.width = data.ConsumeIntegralInRange(1, width + 16);
  stroke.height = data.ConsumeIntegralInRange(1, height + 16);
  stroke.disparity = data.ConsumeIntegralInRange(-4, 64);
  stroke.period = data.ConsumeIntegralInRange(1, 16);
  stroke.density = data.ConsumeIntegral<std::uint8_t>();
  stroke.seed = data.ConsumeIntegral<std::uint8_t>();
  return stroke;
}

// What the stroke puts at its pixel (i, j); nothing of it where false.
bool colour_at(const Stroke& stroke, int i, int j, std::minstd_rand& random, Colour& colour) {
  const auto drawn = static_cast<int>(random() & 255U);
  switch (stroke.pattern) {
    case Pattern::kPlain:
      colour = stroke.colour;
      return true;
    case Pattern::kCheckerboard:
      colour = stroke.colour;
      return ((i / stroke.period) + (j / stroke.period)) % 2 == 0;
    case Pattern::kSpeckles:
      colour = stroke.colour;
      return drawn < stroke.density;
    case Pattern::kPrint: {
      const int light = 128 + (drawn % 64) + 32 * ((i / 3 + 2 * (j / 3)) % 3);
      for (std::size_t c = 0; c < 3; ++c)
        colour[c] = static_cast<std::uint8_t>(std::min(255, stroke.colour[c] * light / 192));
      return true;
    }
    case Pattern::kNoise:
      for (auto& channel : colour) channel = static_cast<std::uint8_t>(random() & 255U);
      return drawn < stroke.density;
  }
  return false;
}

void paint(const Stroke& stroke, int shift, PaintedImage& image) {
  std::minstd_rand random(stroke.seed + 1U);
  for (int j = 0; j < stroke.height && stroke.y + j < image.height; ++j) {
    for (int i = 0; i < stroke.width; ++i) {
      Colour colour{};
      const bool here = colour_at(stroke, i, j, random, colour);
      const int u = stroke.x + i - shift;
      const int v = stroke.y + j;
      if (!here || u < 0 || v < 0 || u >= image.width) continue;
      std::copy(colour.begin(), colour.end(), image.bgr.begin() + v * image.stride + 3 * std::ptrdiff_t{u});
    }
  }
}

PaintedImage grey_image(int width, int height, int padding) {
  PaintedImage image;
  image.width = width;
  image.height = height;
  image.stride = 3 * std::ptrdiff_t{width} + padding;
  image.bgr.assign(static_cast<std::size_t>(image.stride * (height - 1) + 3 * std::ptrdiff_t{width}), 120);
  return image;
}

}  // namespace

PaintedPair paint_pair(FuzzedDataProvider& data, int width, int height) {
  const int padding = data.ConsumeIntegralInRange(0, 7);
  PaintedPair pair{grey_image(width, height, padding), grey_image(width, height, padding)};
  const int num_strokes = data.ConsumeIntegralInRange(0, 12);
  for (int k = 0; k < num_strokes; ++k) {
    const Stroke stroke = take_stroke(data, width, height);
    paint(stroke, 0, pair.left);
    paint(stroke, stroke.disparity, pair.right);
  }
  if (data.ConsumeBool()) {
    const std::vector<std::uint8_t> raw =
        data.ConsumeBytes<std::uint8_t>(data.ConsumeIntegralInRange<std::size_t>(0, 4096));
    std::copy_n(raw.begin(), std::min(raw.size(), pair.left.bgr.size()), pair.left.bgr.begin());
  }
  return pair;
}

}  // namespace markservo::fuzz
