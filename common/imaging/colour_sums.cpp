#include "common/imaging/colour_sums.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/imaging/colour_sums.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace markservo::imaging::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kWordBits = BitMask::kWordBits;
constexpr std::size_t kSums = 10;

using Wide = hn::CappedTag<std::int32_t, 16>;
using Bytes = hn::Rebind<std::uint8_t, Wide>;

void add_pixel(const std::uint8_t* p, std::int64_t* totals) {
  const std::int64_t b = p[0];
  const std::int64_t g = p[1];
  const std::int64_t r = p[2];
  const std::int64_t values[kSums] = {1, b, g, r, b * b, b * g, b * r, g * g, g * r, r * r};
  for (std::size_t k = 0; k < kSums; ++k) totals[k] += values[k];
}

// Adds the pixels from `bgr` on whose bits are set in `lanes`. Vectors whose length shows at run time (SVE) cannot be
// an array's elements, so each sum is a variable.
template <class V>
HWY_INLINE void AddLanes(Wide d, const std::uint8_t* bgr, std::uint64_t lanes, V& count, V& sum_b, V& sum_g, V& sum_r,
                         V& sum_bb, V& sum_bg, V& sum_br, V& sum_gg, V& sum_gr, V& sum_rr) {
  const Bytes bytes;
  std::uint8_t mask_bytes[8];
  std::memcpy(mask_bytes, &lanes, sizeof lanes);
  const auto wanted = hn::LoadMaskBits(d, mask_bytes);
  auto b8 = hn::Zero(bytes);
  auto g8 = hn::Zero(bytes);
  auto r8 = hn::Zero(bytes);
  hn::LoadInterleaved3(bytes, bgr, b8, g8, r8);
  const auto b = hn::IfThenElseZero(wanted, hn::PromoteTo(d, b8));
  const auto g = hn::IfThenElseZero(wanted, hn::PromoteTo(d, g8));
  const auto r = hn::IfThenElseZero(wanted, hn::PromoteTo(d, r8));
  count = hn::Add(count, hn::IfThenElseZero(wanted, hn::Set(d, 1)));
  sum_b = hn::Add(sum_b, b);
  sum_g = hn::Add(sum_g, g);
  sum_r = hn::Add(sum_r, r);
  sum_bb = hn::Add(sum_bb, hn::Mul(b, b));
  sum_bg = hn::Add(sum_bg, hn::Mul(b, g));
  sum_br = hn::Add(sum_br, hn::Mul(b, r));
  sum_gg = hn::Add(sum_gg, hn::Mul(g, g));
  sum_gr = hn::Add(sum_gr, hn::Mul(g, r));
  sum_rr = hn::Add(sum_rr, hn::Mul(r, r));
}

// Moves what the lanes of a sum hold to its total.
template <class V>
HWY_INLINE void Drain(Wide d, V& sum, std::int64_t& total) {
  HWY_ALIGN std::int32_t lanes[16];
  hn::Store(sum, d, lanes);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) total += lanes[i];
  sum = hn::Zero(d);
}

// The same of several, whose totals lie one after the other.
template <class... V>
HWY_INLINE void DrainAll(Wide d, std::int64_t* totals, V&... sums) {
  (Drain(d, sums, *totals++), ...);
}

void AddColours(const std::uint8_t* bgr, std::ptrdiff_t stride, const BitMask& mask, int row_step,
                std::int64_t* totals) {
  const int width = mask.width();
  const Wide d;
  const int n = static_cast<int>(hn::Lanes(d));
  auto count = hn::Zero(d);
  auto b = hn::Zero(d);
  auto g = hn::Zero(d);
  auto r = hn::Zero(d);
  auto bb = hn::Zero(d);
  auto bg = hn::Zero(d);
  auto br = hn::Zero(d);
  auto gg = hn::Zero(d);
  auto gr = hn::Zero(d);
  auto rr = hn::Zero(d);
  // 2^31 / 255^2 = 33025 products fit a lane.
  constexpr int kWordsPerFlush = 33025 / kWordBits;
  int words = 0;
  for (int v = 0; v < mask.height(); v += row_step, bgr += row_step * stride) {
    if (mask.surely_empty(v)) continue;
    const std::uint64_t* chosen = mask.row(v);
    for (int begin = 0; begin < width; begin += kWordBits) {
      std::uint64_t bits = chosen[begin / kWordBits];
      for (int u = begin; bits != 0; u += n, bits = n < kWordBits ? bits >> n : 0) {
        const std::uint64_t here = n < kWordBits ? bits & ((std::uint64_t{1} << n) - 1) : bits;
        if (here == 0) continue;
        if (width < n) {
          for (std::uint64_t rest = bits; rest != 0; rest &= rest - 1) {
            add_pixel(bgr + 3 * static_cast<std::ptrdiff_t>(__builtin_ctzll(rest)), totals);
          }
          break;
        }
        // The last vector of a row begins earlier, with its first lanes off.
        const int at = std::min(u, width - n);
        const std::uint64_t lanes = here << (u - at);
        AddLanes(d, bgr + 3 * static_cast<std::ptrdiff_t>(at), lanes, count, b, g, r, bb, bg, br, gg, gr, rr);
      }
      if (++words == kWordsPerFlush) {
        DrainAll(d, totals, count, b, g, r, bb, bg, br, gg, gr, rr);
        words = 0;
      }
    }
  }
  DrainAll(d, totals, count, b, g, r, bb, bg, br, gg, gr, rr);
}

}  // namespace markservo::imaging::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::imaging {

HWY_EXPORT(AddColours);

double ColourSums::mean(int channel) const {
  return static_cast<double>(first.at(static_cast<std::size_t>(channel))) / static_cast<double>(count);
}

double ColourSums::covariance(int a, int b) const {
  constexpr std::size_t kPlace[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  const std::size_t place = kPlace[a][b];
  return static_cast<double>(second[place]) / static_cast<double>(count) - mean(a) * mean(b);
}

void add_colours(const std::uint8_t* bgr, std::ptrdiff_t stride, const BitMask& chosen, int row_step,
                 ColourSums& sums) {
  std::int64_t totals[10] = {};
  HWY_DYNAMIC_DISPATCH(AddColours)(bgr, stride, chosen, row_step, totals);
  sums.count += totals[0];
  for (std::size_t k = 0; k < 3; ++k) sums.first[k] += totals[1 + k];
  for (std::size_t k = 0; k < 6; ++k) sums.second[k] += totals[4 + k];
}

}  // namespace markservo::imaging
#endif  // HWY_ONCE
