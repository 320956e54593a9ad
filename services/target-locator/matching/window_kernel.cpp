#include "services/target-locator/matching/window_kernel.hpp"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/target-locator/matching/window_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

#include "services/target-locator/image/row_sampler-inl.h"

HWY_BEFORE_NAMESPACE();
namespace markservo::target_locator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE hn::Mask<Floats> mask_of(std::uint32_t bits) {
  std::uint8_t bytes[8] = {};
  std::memcpy(bytes, &bits, sizeof bits);
  return hn::LoadMaskBits(Floats(), bytes);
}

// Sums of a quantity times 1 and dv, lane by lane; a lane has one du. Vectors whose length shows at run time (SVE)
// cannot be members or elements, so each sum is a variable.
template <class V>
HWY_INLINE void add_first(V q, V dv, V& plain, V& once) {
  plain = hn::Add(plain, q);
  once = hn::MulAdd(q, dv, once);
}

// The same times dv^2 as well.
template <class V>
HWY_INLINE void add(V q, V dv, V& plain, V& once, V& twice) {
  const auto q_dv = hn::Mul(q, dv);
  plain = hn::Add(plain, q);
  once = hn::Add(once, q_dv);
  twice = hn::MulAdd(q_dv, dv, twice);
}

template <class V>
HWY_INLINE float total(V lanes) {
  const Floats d;
  return hn::GetLane(hn::SumOfLanes(d, lanes));
}

template <class V>
HWY_INLINE void collect_first(V du, V plain, V once, WindowMoments& moments) {
  moments[0] += total(plain);
  moments[1] += total(hn::Mul(plain, du));
  moments[2] += total(once);
}

template <class V>
HWY_INLINE void collect(V du, V plain, V once, V twice, WindowMoments& moments) {
  collect_first(du, plain, once, moments);
  moments[3] += total(hn::Mul(hn::Mul(plain, du), du));
  moments[4] += total(hn::Mul(once, du));
  moments[5] += total(twice);
}

HWY_INLINE hn::Vec<Floats> du_of(const WindowFrame& window, int lane) {
  const Floats d;
  return hn::MulAdd(hn::Iota(d, static_cast<float>(lane)), hn::Set(d, window.scale), hn::Set(d, window.du));
}

WindowSums SumWindow(const PlaneImage& left, const PlaneImage& gradient, const WindowFrame& window, float about) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto inverse_scale = hn::Set(d, 1.0F / window.scale);
  const auto half_inverse = hn::Set(d, 0.5F / window.scale);
  const auto mean = hn::Set(d, about);
  WindowSums sums;
  for (int lane = 0; lane < WindowFrame::kLanes; lane += lanes) {
    auto n = hn::Zero(d);
    auto grey_sum = hn::Zero(d);
    auto grey_squares = hn::Zero(d);
    auto gradient_plain = hn::Zero(d);
    auto gradient_once = hn::Zero(d);
    auto product_plain = hn::Zero(d);
    auto product_once = hn::Zero(d);
    auto newton_plain = hn::Zero(d);
    auto newton_once = hn::Zero(d);
    auto newton_twice = hn::Zero(d);
    auto information_plain = hn::Zero(d);
    auto information_once = hn::Zero(d);
    auto information_twice = hn::Zero(d);
    for (int j = 0; j < window.height; ++j) {
      const auto used = mask_of(static_cast<std::uint32_t>(window.used[static_cast<std::size_t>(j)]) >> lane);
      const float* p = left.row(window.row + j) + window.column + lane;
      const auto grey = hn::IfThenElseZero(used, hn::Sub(hn::LoadU(d, p), mean));
      const auto slope = hn::Mul(half_inverse, hn::Sub(hn::LoadU(d, p + 1), hn::LoadU(d, p - 1)));
      const auto g = hn::IfThenElseZero(
          used, hn::Mul(inverse_scale, hn::LoadU(d, gradient.row(window.row + j) + window.column + lane)));
      const auto dv = hn::Set(d, window.dv + static_cast<float>(j) * window.scale);
      n = hn::Add(n, hn::IfThenElseZero(used, hn::Set(d, 1.0F)));
      grey_sum = hn::Add(grey_sum, grey);
      grey_squares = hn::MulAdd(grey, grey, grey_squares);
      add_first(g, dv, gradient_plain, gradient_once);
      add_first(hn::Mul(g, grey), dv, product_plain, product_once);
      add(hn::IfThenElseZero(used, hn::Mul(g, slope)), dv, newton_plain, newton_once, newton_twice);
      add(hn::Mul(g, g), dv, information_plain, information_once, information_twice);
    }
    const auto du = du_of(window, lane);
    sums.n += total(n);
    sums.grey += total(grey_sum);
    sums.grey_squares += total(grey_squares);
    collect_first(du, gradient_plain, gradient_once, sums.gradient);
    collect_first(du, product_plain, product_once, sums.gradient_grey);
    collect(du, newton_plain, newton_once, newton_twice, sums.newton);
    collect(du, information_plain, information_once, information_twice, sums.information);
  }
  return sums;
}

ComparisonSums CompareWindow(const PlaneImage& left, const PlaneImage& gradient, const PlaneImage& right_rows,
                             const WindowFrame& window, const RightColumns& columns, float about) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto inverse_scale = hn::Set(d, 1.0F / window.scale);
  const auto mean = hn::Set(d, about);
  const float step = columns.per_u * window.scale;
  ComparisonSums sums;
  for (int lane = 0; lane < WindowFrame::kLanes; lane += lanes) {
    auto right_sum = hn::Zero(d);
    auto squares = hn::Zero(d);
    auto product = hn::Zero(d);
    auto of_right_plain = hn::Zero(d);
    auto of_right_once = hn::Zero(d);
    for (int j = 0; j < window.height; ++j) {
      const auto used = mask_of(static_cast<std::uint32_t>(window.used[static_cast<std::size_t>(j)]) >> lane);
      const float dv = window.dv + static_cast<float>(j) * window.scale;
      const float x0 = columns.base + columns.per_u * window.du + columns.per_v * dv + step * static_cast<float>(lane);
      const auto right = hn::IfThenElseZero(
          used, hn::Sub(sample_row(right_rows.row(window.row + j), right_rows.width, x0, step), mean));
      const auto grey =
          hn::IfThenElseZero(used, hn::Sub(hn::LoadU(d, left.row(window.row + j) + window.column + lane), mean));
      const auto g = hn::Mul(inverse_scale, hn::LoadU(d, gradient.row(window.row + j) + window.column + lane));
      right_sum = hn::Add(right_sum, right);
      squares = hn::MulAdd(right, right, squares);
      product = hn::MulAdd(right, grey, product);
      add_first(hn::IfThenElseZero(used, hn::Mul(g, right)), hn::Set(d, dv), of_right_plain, of_right_once);
    }
    sums.right += total(right_sum);
    sums.squares += total(squares);
    sums.product += total(product);
    collect_first(du_of(window, lane), of_right_plain, of_right_once, sums.gradient_right);
  }
  return sums;
}

}  // namespace markservo::target_locator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::target_locator {

HWY_EXPORT(SumWindow);
HWY_EXPORT(CompareWindow);

WindowSums sum_window(const PlaneImage& left, const PlaneImage& gradient, const WindowFrame& window, float about) {
  return HWY_DYNAMIC_DISPATCH(SumWindow)(left, gradient, window, about);
}

ComparisonSums compare_window(const PlaneImage& left, const PlaneImage& gradient, const PlaneImage& right_rows,
                              const WindowFrame& window, const RightColumns& columns, float about) {
  return HWY_DYNAMIC_DISPATCH(CompareWindow)(left, gradient, right_rows, window, columns, about);
}

}  // namespace markservo::target_locator
#endif  // HWY_ONCE
