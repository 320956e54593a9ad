#include "services/target-locator/image/projection_kernel.hpp"

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/target-locator/image/projection_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace markservo::target_locator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Ints = hn::CappedTag<std::int32_t, PlaneImage::kRoom>;
using Bytes = hn::Rebind<std::uint8_t, Ints>;

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

}  // namespace markservo::target_locator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::target_locator {

HWY_EXPORT(ProjectPixels);

void project_pixels(const std::uint8_t* bgr, int width, int height, const ColourMap& map, PlaneImage& plane) {
  plane.resize(width, height);
  HWY_DYNAMIC_DISPATCH(ProjectPixels)(bgr, width, height, map, plane);
}

}  // namespace markservo::target_locator
#endif  // HWY_ONCE
