#include "services/target-locator/image/image_kernel.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/target-locator/image/image_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace markservo::target_locator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Ints = hn::CappedTag<std::int32_t, PlaneImage::kRoom>;
using Bytes = hn::Rebind<std::uint8_t, Ints>;
using Floats = hn::CappedTag<float, PlaneImage::kRoom>;

void ProjectPixels(const std::uint8_t* bgr, int width, int height, const ColourMap& map, PlaneImage& plane) {
  const Ints di;
  const Bytes bytes;
  const hn::RebindToFloat<Ints> d;
  const int n = static_cast<int>(hn::Lanes(di));
  const auto of_blue = hn::Set(d, map.weights[0]);
  const auto of_green = hn::Set(d, map.weights[1]);
  const auto of_red = hn::Set(d, map.weights[2]);
  const auto offset = hn::Set(d, map.offset);
  for (int y = 0; y < height; ++y, bgr += std::ptrdiff_t{3} * width) {
    float* out = plane.row(y);
    if (width < n) {
      for (int x = 0; x < width; ++x) {
        const std::uint8_t* p = bgr + std::ptrdiff_t{3} * x;
        out[x] = map.offset + map.weights[0] * static_cast<float>(p[0]) + map.weights[1] * static_cast<float>(p[1]) +
                 map.weights[2] * static_cast<float>(p[2]);
      }
      continue;
    }
    for (int begin = 0; begin < width; begin += n) {
      const int x = std::min(begin, width - n);  // the last ones once more, among others
      auto b = hn::Zero(bytes);
      auto g = hn::Zero(bytes);
      auto r = hn::Zero(bytes);
      hn::LoadInterleaved3(bytes, bgr + std::ptrdiff_t{3} * x, b, g, r);
      auto sum = hn::MulAdd(of_blue, hn::ConvertTo(d, hn::PromoteTo(di, b)), offset);
      sum = hn::MulAdd(of_green, hn::ConvertTo(d, hn::PromoteTo(di, g)), sum);
      sum = hn::MulAdd(of_red, hn::ConvertTo(d, hn::PromoteTo(di, r)), sum);
      hn::StoreU(sum, d, out + x);
    }
  }
}

void FillGradients(const PlaneImage& image, bool zero_border, Gradients& gradients) {
  const Floats d;
  const int n = static_cast<int>(hn::Lanes(d));
  const int w = image.width;
  const int h = image.height;
  // A row's last vector may reach into the room before the row after it.
  PlaneImage& lines = gradients.lines;
  lines.resize(w, 6);
  std::array<float*, 3> three = {lines.row(0), lines.row(1), lines.row(2)};
  float* const smooth = lines.row(3);
  float* const rise = lines.row(5);
  const auto load = [&](int y, float* line) {
    const bool outside = zero_border && (y < 0 || y >= h);
    const float* in = image.row(std::clamp(y, 0, h - 1));
    if (outside) {
      std::fill(line - 1, line + w + 1, 0.0F);
      return;
    }
    std::copy(in, in + w, line);
    line[-1] = zero_border ? 0.0F : in[0];
    line[w] = zero_border ? 0.0F : in[w - 1];
  };
  load(-1, three[0]);
  load(0, three[1]);
  const auto two = hn::Set(d, 2.0F);
  const auto eighth = hn::Set(d, 0.125F);
  for (int y = 0; y < h; ++y) {
    load(y + 1, three[2]);
    // From one pixel before the row to one behind it, whole vectors.
    for (int x = -1; x < w + 1; x += n) {
      const auto above = hn::LoadU(d, three[0] + x);
      const auto here = hn::LoadU(d, three[1] + x);
      const auto below = hn::LoadU(d, three[2] + x);
      hn::StoreU(hn::MulAdd(two, here, hn::Add(above, below)), d, smooth + x);
      hn::StoreU(hn::Sub(below, above), d, rise + x);
    }
    float* gc = gradients.column.row(y);
    float* gr = gradients.row.row(y);
    for (int x = 0; x < w; x += n) {
      hn::StoreU(hn::Mul(eighth, hn::Sub(hn::LoadU(d, smooth + x + 1), hn::LoadU(d, smooth + x - 1))), d, gc + x);
      const auto beside = hn::Add(hn::LoadU(d, rise + x - 1), hn::LoadU(d, rise + x + 1));
      hn::StoreU(hn::Mul(eighth, hn::MulAdd(two, hn::LoadU(d, rise + x), beside)), d, gr + x);
    }
    std::rotate(three.begin(), three.begin() + 1, three.end());
  }
}

}  // namespace markservo::target_locator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::target_locator {

HWY_EXPORT(ProjectPixels);
HWY_EXPORT(FillGradients);

void project_pixels(const std::uint8_t* bgr, int width, int height, const ColourMap& map, PlaneImage& plane) {
  plane.resize(width, height);
  HWY_DYNAMIC_DISPATCH(ProjectPixels)(bgr, width, height, map, plane);
}

void fill_gradients(const PlaneImage& image, bool zero_border, Gradients& gradients) {
  HWY_DYNAMIC_DISPATCH(FillGradients)(image, zero_border, gradients);
}

}  // namespace markservo::target_locator
#endif  // HWY_ONCE
