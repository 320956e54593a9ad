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

// Sums of a quantity times powers of dv, lane by lane; a lane has one du.
struct Columns {
  hn::Vec<Floats> plain;
  hn::Vec<Floats> once;
  hn::Vec<Floats> twice;

  template <class V>
  HWY_INLINE void add(V q, V dv) {
    const auto q_dv = hn::Mul(q, dv);
    plain = hn::Add(plain, q);
    once = hn::Add(once, q_dv);
    twice = hn::MulAdd(q_dv, dv, twice);
  }
  template <class V>
  HWY_INLINE void add_first(V q, V dv) {
    plain = hn::Add(plain, q);
    once = hn::MulAdd(q, dv, once);
  }
};

HWY_INLINE Columns no_columns() {
  const Floats d;
  return {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
}

template <class V>
HWY_INLINE float total(V lanes) {
  const Floats d;
  return hn::GetLane(hn::SumOfLanes(d, lanes));
}

template <class V>
HWY_INLINE void collect_first(const Columns& columns, V du, WindowMoments& moments) {
  moments[0] += total(columns.plain);
  moments[1] += total(hn::Mul(columns.plain, du));
  moments[2] += total(columns.once);
}

template <class V>
HWY_INLINE void collect(const Columns& columns, V du, WindowMoments& moments) {
  collect_first(columns, du, moments);
  moments[3] += total(hn::Mul(hn::Mul(columns.plain, du), du));
  moments[4] += total(hn::Mul(columns.once, du));
  moments[5] += total(columns.twice);
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
    Columns of_gradient = no_columns();
    Columns of_grey = no_columns();
    Columns newton = no_columns();
    Columns information = no_columns();
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
      of_gradient.add_first(g, dv);
      of_grey.add_first(hn::Mul(g, grey), dv);
      newton.add(hn::IfThenElseZero(used, hn::Mul(g, slope)), dv);
      information.add(hn::Mul(g, g), dv);
    }
    const auto du = du_of(window, lane);
    sums.n += total(n);
    sums.grey += total(grey_sum);
    sums.grey_squares += total(grey_squares);
    collect_first(of_gradient, du, sums.gradient);
    collect_first(of_grey, du, sums.gradient_grey);
    collect(newton, du, sums.newton);
    collect(information, du, sums.information);
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
    Columns of_right = no_columns();
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
      of_right.add_first(hn::IfThenElseZero(used, hn::Mul(g, right)), hn::Set(d, dv));
    }
    sums.right += total(right_sum);
    sums.squares += total(squares);
    sums.product += total(product);
    collect_first(of_right, du_of(window, lane), sums.gradient_right);
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
