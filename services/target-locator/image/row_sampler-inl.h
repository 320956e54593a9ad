// Samples a row between its pixels, in vector code. Per target: included by kernels, after hwy/highway.h.

#if defined(MARKSERVO_ROW_SAMPLER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MARKSERVO_ROW_SAMPLER_INL_H
#undef MARKSERVO_ROW_SAMPLER_INL_H
#else
#define MARKSERVO_ROW_SAMPLER_INL_H
#endif

#include <algorithm>

#include "services/target-locator/image/plane_image.hpp"

HWY_BEFORE_NAMESPACE();
namespace markservo::target_locator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, PlaneImage::kRoom>;

// Catmull-Rom's cubic through p0..p3, at f of [0, 1) from p1 to p2.
template <class V>
HWY_INLINE V cubic(V p0, V p1, V p2, V p3, V f) {
  const Floats d;
  // p1 + f/2 ((p2 - p0) + f ((2 p0 - 5 p1 + 4 p2 - p3) + f (3 (p1 - p2) + p3 - p0)))
  const auto third = hn::MulAdd(hn::Set(d, 3.0F), hn::Sub(p1, p2), hn::Sub(p3, p0));
  auto second = hn::MulAdd(hn::Set(d, 4.0F), p2, hn::Sub(hn::Add(p0, p0), p3));
  second = hn::NegMulAdd(hn::Set(d, 5.0F), p1, second);
  const auto slope = hn::MulAdd(f, hn::MulAdd(f, third, second), hn::Sub(p2, p0));
  return hn::MulAdd(hn::Mul(hn::Set(d, 0.5F), f), slope, p1);
}

// A row of `width` >= 4 pixels, with room around it, at columns x0, x0 + step, x0 + 2 step ...; the outermost cubic
// goes on beyond the border's neighbours.
HWY_INLINE hn::Vec<Floats> sample_row(const float* row, int width, float x0, float step) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  [[maybe_unused]] const int lanes = static_cast<int>(hn::Lanes(d));  // known to the compiler but for SVE
  // Also of what is no number.
  constexpr float kFar = 1e6F;
  x0 = x0 > -kFar ? std::min(x0, kFar) : -kFar;
  step = step > -kFar ? std::min(step, kFar) : -kFar;
  auto x = hn::MulAdd(hn::Iota(d, 0.0F), hn::Set(d, step), hn::Set(d, x0));
  x = hn::Min(hn::Max(x, hn::Set(d, 1.0F)), hn::Set(d, static_cast<float>(width) - 2.001F));
  const auto whole = hn::ConvertTo(di, x);
  const auto f = hn::Sub(x, hn::ConvertTo(d, whole));
#if HWY_TARGET != HWY_SCALAR
  if (lanes >= 8) {
    // Neighbours are near each other: two vectors of the row hold all pixels that are needed.
    const int first = static_cast<int>(std::clamp(x0, 1.0F, static_cast<float>(width - 3))) - 1;
    const float reach = step * static_cast<float>(lanes - 1);
    if (reach >= 0.0F && reach < static_cast<float>(2 * lanes - 4)) {
      const auto low = hn::LoadU(d, row + first);
      const auto high = hn::LoadU(d, row + std::min(first + lanes, width));
      const auto at = hn::Sub(whole, hn::Set(di, first + 1));
      const auto tap = [&](int k) {
        const auto index = hn::Add(at, hn::Set(di, k));
        const auto in_low = hn::RebindMask(d, hn::Gt(hn::Set(di, lanes), index));
        const auto lane = hn::IndicesFromVec(d, hn::And(index, hn::Set(di, lanes - 1)));
        return hn::IfThenElse(in_low, hn::TableLookupLanes(low, lane), hn::TableLookupLanes(high, lane));
      };
      return cubic(tap(0), tap(1), tap(2), tap(3), f);
    }
  }
#endif
  return cubic(hn::GatherIndex(d, row - 1, whole), hn::GatherIndex(d, row, whole), hn::GatherIndex(d, row + 1, whole),
               hn::GatherIndex(d, row + 2, whole), f);
}

}  // namespace markservo::target_locator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
