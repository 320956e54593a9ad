#include "services/target-locator/features/tensor_kernel.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/target-locator/features/tensor_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace markservo::target_locator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, PlaneImage::kRoom>;

constexpr int kRadius = 2;
// exp(-k^2 / 2), k = 0..2, divided by the sum over -2..2.
constexpr float kMiddle = 0.40261995F;
constexpr float kNear = 0.24420134F;
constexpr float kFar = 0.05448868F;

template <class V>
HWY_INLINE V smooth(V far_before, V before, V middle, V behind, V far_behind) {
  const Floats d;
  auto sum = hn::Mul(hn::Set(d, kMiddle), middle);
  sum = hn::MulAdd(hn::Set(d, kNear), hn::Add(before, behind), sum);
  return hn::MulAdd(hn::Set(d, kFar), hn::Add(far_before, far_behind), sum);
}

constexpr std::size_t kProducts = 3;            // of gradients: column column, column row, row row
constexpr std::size_t kRing = 2 * kRadius + 1;  // rows that are smoothed at once
using ProductRows = std::array<float*, kProducts>;

// The products of a row's gradients, smoothed along it. Beyond the border gradients are 0. The first rows of `lines`
// are room.
HWY_INLINE void smooth_products(const float* gc, const float* gr, int w, PlaneImage& lines, const ProductRows& out) {
  const Floats d;
  const int n = static_cast<int>(hn::Lanes(d));
  for (int x = 0; x < w; x += n) {
    const auto c = hn::LoadU(d, gc + x);
    const auto r = hn::LoadU(d, gr + x);
    hn::StoreU(hn::Mul(c, c), d, lines.row(0) + x);
    hn::StoreU(hn::Mul(c, r), d, lines.row(1) + x);
    hn::StoreU(hn::Mul(r, r), d, lines.row(2) + x);
  }
  for (std::size_t p = 0; p < kProducts; ++p) {
    float* in = lines.row(static_cast<int>(p));
    for (int k = 0; k < kRadius; ++k) in[w + k] = in[-1 - k] = 0.0F;
    for (int x = 0; x < w; x += n) {
      hn::StoreU(smooth(hn::LoadU(d, in + x - 2), hn::LoadU(d, in + x - 1), hn::LoadU(d, in + x),
                        hn::LoadU(d, in + x + 1), hn::LoadU(d, in + x + 2)),
                 d, out[p] + x);
    }
  }
}

// Weight and roundness of a row, from the products of it and of the rows above and below.
HWY_INLINE void measure_row(const std::array<ProductRows, kRing>& ring, float trace_floor, int w, float* weight,
                            float* roundness) {
  const Floats d;
  const int n = static_cast<int>(hn::Lanes(d));
  const auto floor = hn::Set(d, trace_floor);
  const auto zero = hn::Zero(d);
  for (int x = 0; x < w; x += n) {
    const auto down = [&](std::size_t p) {
      return smooth(hn::LoadU(d, ring[0][p] + x), hn::LoadU(d, ring[1][p] + x), hn::LoadU(d, ring[2][p] + x),
                    hn::LoadU(d, ring[3][p] + x), hn::LoadU(d, ring[4][p] + x));
    };
    const auto c = down(0);
    const auto b = down(1);
    const auto a = down(2);
    const auto trace = hn::Add(a, c);
    const auto determinant = hn::Max(zero, hn::NegMulAdd(b, b, hn::Mul(a, c)));
    const auto textured = hn::And(hn::Ge(trace, floor), hn::Gt(trace, zero));
    const auto inverse = hn::IfThenElseZero(textured, hn::Div(hn::Set(d, 1.0F), trace));
    const auto w_here = hn::Mul(determinant, inverse);
    hn::StoreU(w_here, d, weight + x);
    hn::StoreU(hn::Mul(hn::Set(d, 4.0F), hn::Mul(w_here, inverse)), d, roundness + x);
  }
}

void FillMeasures(const Gradients& gradients, float trace_floor, CornerMeasures& measures) {
  const int w = gradients.column.width;
  const int h = gradients.column.height;
  PlaneImage& lines = measures.lines;
  lines.resize(w, static_cast<int>(kProducts * (1 + kRing)));
  std::array<ProductRows, kRing> ring{};
  for (std::size_t k = 0; k < kRing; ++k) {
    for (std::size_t p = 0; p < kProducts; ++p) {
      ring[k][p] = lines.row(static_cast<int>(kProducts * (1 + k) + p));
      std::fill(ring[k][p], ring[k][p] + w, 0.0F);
    }
  }
  for (int y = -kRadius; y < h; ++y) {
    const int next = y + kRadius;
    if (next < h) {
      smooth_products(gradients.column.row(next), gradients.row.row(next), w, lines, ring[kRing - 1]);
    } else {
      for (float* row : ring[kRing - 1]) std::fill(row, row + w, 0.0F);
    }
    if (y >= 0) measure_row(ring, trace_floor, w, measures.weight.row(y), measures.roundness.row(y));
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
  }
}

void FindMaxima(const CornerMeasures& measures, int y, float min_weight, float min_roundness,
                const std::uint64_t* inside, std::uint64_t* maxima) {
  const Floats d;
  const int n = static_cast<int>(hn::Lanes(d));
  const PlaneImage& weight = measures.weight;
  const int w = weight.width;
  const bool top = y == 0;
  const bool bottom = y + 1 == weight.height;
  const float* here = weight.row(y);
  const float* above = top ? here : weight.row(y - 1);
  const float* below = bottom ? here : weight.row(y + 1);
  const float* roundness = measures.roundness.row(y);
  constexpr int kWordBits = Mask::kWordBits;
  for (int begin = 0; begin < w; begin += kWordBits) {
    std::uint64_t candidates = inside[begin / kWordBits];
    std::uint64_t found = 0;
    for (int x = begin; candidates != 0 && x < begin + kWordBits; x += n) {
      const int shift = x - begin;
      const std::uint64_t own = n < kWordBits ? (candidates >> shift) & ((std::uint64_t{1} << n) - 1) : candidates;
      if (own == 0) continue;
      const auto value = hn::LoadU(d, here + x);
      auto maximum = hn::And(hn::Ge(value, hn::Set(d, min_weight)),
                             hn::Ge(hn::LoadU(d, roundness + x), hn::Set(d, min_roundness)));
      // Of what comes before none may be as great, of what comes behind none greater; what lies outside does not count.
      const auto column = hn::Iota(d, static_cast<float>(x));
      const auto first = hn::Eq(column, hn::Zero(d));
      const auto last = hn::Eq(column, hn::Set(d, static_cast<float>(w - 1)));
      const auto before = [&](const float* p) { return hn::Gt(value, hn::LoadU(d, p)); };
      const auto behind = [&](const float* p) { return hn::Ge(value, hn::LoadU(d, p)); };
      const auto require = [&](auto holds) { maximum = hn::And(maximum, holds); };
      require(hn::Or(first, before(here + x - 1)));
      require(hn::Or(last, behind(here + x + 1)));
      if (!top) {
        require(hn::Or(first, before(above + x - 1)));
        require(before(above + x));
        require(hn::Or(last, before(above + x + 1)));
      }
      if (!bottom) {
        require(hn::Or(first, behind(below + x - 1)));
        require(behind(below + x));
        require(hn::Or(last, behind(below + x + 1)));
      }
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(d, maximum, bytes);
      std::uint64_t bits = 0;
      std::memcpy(&bits, bytes, sizeof bits);
      found |= (bits & own) << shift;
    }
    maxima[begin / kWordBits] = found;
  }
}

}  // namespace markservo::target_locator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::target_locator {

HWY_EXPORT(FillMeasures);
HWY_EXPORT(FindMaxima);

void fill_measures(const Gradients& gradients, float trace_floor, CornerMeasures& measures) {
  HWY_DYNAMIC_DISPATCH(FillMeasures)(gradients, trace_floor, measures);
}

void find_maxima(const CornerMeasures& measures, int y, float min_weight, float min_roundness,
                 const std::uint64_t* inside, std::uint64_t* maxima) {
  HWY_DYNAMIC_DISPATCH(FindMaxima)(measures, y, min_weight, min_roundness, inside, maxima);
}

}  // namespace markservo::target_locator
#endif  // HWY_ONCE
