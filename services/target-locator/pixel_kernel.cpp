#include "services/target-locator/pixel_kernel.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/target-locator/pixel_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace markservo::target_locator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Ints = hn::CappedTag<int32_t, 16>;
using Bytes = hn::Rebind<std::uint8_t, Ints>;

void ProjectPixels(const std::uint8_t* bgr, std::size_t count, const std::array<float, 3>& weights, float* out) {
  const Ints di;
  const Bytes bytes;
  const hn::RebindToFloat<Ints> d;
  const std::size_t n = hn::Lanes(di);
  const auto project = [&](std::size_t i) {
    auto b = hn::Zero(bytes);
    auto g = hn::Zero(bytes);
    auto r = hn::Zero(bytes);
    hn::LoadInterleaved3(bytes, bgr + 3 * i, b, g, r);
    auto sum = hn::Mul(hn::Set(d, weights[0]), hn::ConvertTo(d, hn::PromoteTo(di, b)));
    sum = hn::MulAdd(hn::Set(d, weights[1]), hn::ConvertTo(d, hn::PromoteTo(di, g)), sum);
    sum = hn::MulAdd(hn::Set(d, weights[2]), hn::ConvertTo(d, hn::PromoteTo(di, r)), sum);
    hn::StoreU(sum, d, out + i);
  };
  std::size_t i = 0;
  for (; i + n <= count; i += n) project(i);
  if (i == count) return;
  if (count >= n) return project(count - n);  // the last ones once more, among others
  for (; i < count; ++i) {
    out[i] = weights[0] * static_cast<float>(bgr[3 * i]) + weights[1] * static_cast<float>(bgr[3 * i + 1]) +
             weights[2] * static_cast<float>(bgr[3 * i + 2]);
  }
}

ColourSums SumColours(const std::uint8_t* bgr, const std::uint8_t* chosen, std::size_t count) {
  const Ints d;
  const Bytes bytes;
  const std::size_t n = hn::Lanes(d);
  ColourSums total;
  std::size_t i = 0;
  // 2^31 / 255^2 = 33025 products fit a lane.
  constexpr std::size_t kSteps = 32768;
  while (i + n <= count) {
    decltype(hn::Zero(d)) sums[10];
    for (auto& sum : sums) sum = hn::Zero(d);
    const std::size_t end = std::min(count - n, i + (kSteps - 1) * n);
    for (; i <= end; i += n) {
      auto b8 = hn::Zero(bytes);
      auto g8 = hn::Zero(bytes);
      auto r8 = hn::Zero(bytes);
      hn::LoadInterleaved3(bytes, bgr + 3 * i, b8, g8, r8);
      const auto one = hn::PromoteTo(d, hn::LoadU(bytes, chosen + i));
      const auto b = hn::Mul(hn::PromoteTo(d, b8), one);
      const auto g = hn::Mul(hn::PromoteTo(d, g8), one);
      const auto r = hn::Mul(hn::PromoteTo(d, r8), one);
      sums[0] = hn::Add(sums[0], one);
      sums[1] = hn::Add(sums[1], b);
      sums[2] = hn::Add(sums[2], g);
      sums[3] = hn::Add(sums[3], r);
      sums[4] = hn::Add(sums[4], hn::Mul(b, b));
      sums[5] = hn::Add(sums[5], hn::Mul(b, g));
      sums[6] = hn::Add(sums[6], hn::Mul(b, r));
      sums[7] = hn::Add(sums[7], hn::Mul(g, g));
      sums[8] = hn::Add(sums[8], hn::Mul(g, r));
      sums[9] = hn::Add(sums[9], hn::Mul(r, r));
    }
    const auto lanes = [&](std::size_t k) {
      HWY_ALIGN int32_t values[16];
      hn::Store(sums[k], d, values);
      std::int64_t sum = 0;
      for (std::size_t lane = 0; lane < n; ++lane) sum += values[lane];
      return sum;
    };
    total.count += lanes(0);
    for (std::size_t k = 0; k < 3; ++k) total.first[k] += lanes(1 + k);
    for (std::size_t k = 0; k < 6; ++k) total.second[k] += lanes(4 + k);
  }
  for (; i < count; ++i) {
    if (chosen[i] == 0) continue;
    const std::int64_t b = bgr[3 * i];
    const std::int64_t g = bgr[3 * i + 1];
    const std::int64_t r = bgr[3 * i + 2];
    ++total.count;
    const std::int64_t first[] = {b, g, r};
    const std::int64_t second[] = {b * b, b * g, b * r, g * g, g * r, r * r};
    for (std::size_t k = 0; k < 3; ++k) total.first[k] += first[k];
    for (std::size_t k = 0; k < 6; ++k) total.second[k] += second[k];
  }
  return total;
}

}  // namespace markservo::target_locator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::target_locator {

HWY_EXPORT(ProjectPixels);
HWY_EXPORT(SumColours);

void project_pixels(const std::uint8_t* bgr, std::size_t count, const std::array<float, 3>& weights, float* out) {
  HWY_DYNAMIC_DISPATCH(ProjectPixels)(bgr, count, weights, out);
}

ColourSums sum_colours(const std::uint8_t* bgr, const std::uint8_t* chosen, std::size_t count) {
  return HWY_DYNAMIC_DISPATCH(SumColours)(bgr, chosen, count);
}

}  // namespace markservo::target_locator
#endif  // HWY_ONCE
