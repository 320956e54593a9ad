#include "services/mark-detector/learning/learning_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "services/mark-detector/colour/hue.hpp"
#include "services/mark-detector/colour/luma_equalisation.hpp"

namespace markservo::mark_detector {
namespace {

// Left and top inside, right and bottom outside.
struct Bounds {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  bool holds(int u, int v) const { return u >= left && u < right && v >= top && v < bottom; }
  double area() const { return double(right - left) * double(bottom - top); }
};

// The box, widened to all sides as far as the picture reaches.
Bounds widened(const LearningPicture& picture, int across, int down) {
  return {std::max(0, picture.x - across), std::max(0, picture.y - down),
          picture.x + picture.width + std::min(across, picture.image.width - picture.x - picture.width),
          picture.y + picture.height + std::min(down, picture.image.height - picture.y - picture.height)};
}

// 1 in the middle, 0 at the ends.
double tent(int i, int size) {
  return 1.0 - std::abs((2.0 * i + 1.0) / size - 1.0);
}

LumaShift shift_of(const ImageView& image, bool equalise) {
  if (!equalise) return no_shift();
  LumaHistogram histogram{};
  accumulate(image, histogram);
  return against_darkness(equalising_shift(histogram));
}

LearningPixel pixel_of(const std::uint8_t* p, const LumaShift& shift) {
  const Hsv hsv = hsv_of({double(p[0]), double(p[1]), double(p[2])});
  LearningPixel pixel;
  pixel.hue_deg = hsv.hue_deg;
  pixel.saturation = hsv.saturation;
  pixel.chroma = hsv.chroma;
  pixel.level = hsv.value;
  const int levels = luma(p[0], p[1], p[2]);
  const double brightening = shift[static_cast<std::size_t>(levels)];
  pixel.luma = levels;
  pixel.value = std::min(kWhiteLevel, hsv.value + brightening) / kWhiteLevel;
  if (hsv.value > 0.0) {
    pixel.x = (p[2] - p[1]) / hsv.value;
    pixel.y = (p[1] - p[0]) / hsv.value;
  }
  return pixel;
}

}  // namespace

std::vector<LearningPixel> learning_pixels(const std::vector<LearningPicture>& pictures, bool equalise,
                                           const LearningPixelParameters& parameters) {
  std::vector<LearningPixel> inside;
  std::vector<LearningPixel> around;
  for (std::size_t number = 0; number < pictures.size(); ++number) {
    const LearningPicture& picture = pictures[number];
    const LumaShift shift = shift_of(picture.image, equalise);
    const auto share = [](double of, int edge) { return static_cast<int>(std::ceil(of * edge)); };
    const int gap_across = std::max(parameters.gap_least, share(parameters.gap_share, picture.width));
    const int gap_down = std::max(parameters.gap_least, share(parameters.gap_share, picture.height));
    const Bounds box = widened(picture, 0, 0);
    const Bounds gap = widened(picture, gap_across, gap_down);
    const Bounds all = widened(picture, gap_across + share(parameters.reach_share, picture.width),
                               gap_down + share(parameters.reach_share, picture.height));
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(all.area() / parameters.most))));
    for (int v = all.top; v < all.bottom; v += step) {
      for (int u = all.left; u < all.right; u += step) {
        const bool in_box = box.holds(u, v);
        if (!in_box && gap.holds(u, v)) continue;
        LearningPixel pixel = pixel_of(picture.image.pixel(u, v), shift);
        pixel.in_box = in_box;
        pixel.picture = number;
        pixel.area = double(step) * step;
        if (in_box) pixel.middle = tent(u - picture.x, picture.width) * tent(v - picture.y, picture.height);
        (in_box ? inside : around).push_back(pixel);
      }
    }
  }
  inside.insert(inside.end(), around.begin(), around.end());
  return inside;
}

}  // namespace markservo::mark_detector
