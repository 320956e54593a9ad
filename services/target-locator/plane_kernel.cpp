#include "services/target-locator/plane_kernel.hpp"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/target-locator/plane_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace markservo::target_locator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, PlaneTemplate::kLanes>;

template <class V>
double sum_of(V lanes) {
  const Floats d;
  HWY_ALIGN float values[PlaneTemplate::kLanes];
  hn::Store(lanes, d, values);
  double sum = 0.0;
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) sum += static_cast<double>(values[i]);
  return sum;
}

void SampleRows(const float* image, int width, const PlaneTemplate& t, const ColumnMap& columns, float* warped) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  const auto least = hn::Set(d, 1.0F);
  const auto most = hn::Set(d, static_cast<float>(width) - 2.001F);
  const auto half = hn::Set(d, 0.5F);
  for (std::size_t i = 0; i < t.padded(); i += hn::Lanes(d)) {
    auto x = hn::MulAdd(hn::Set(d, columns.per_column), hn::LoadU(d, &t.column[i]), hn::Set(d, columns.base));
    x = hn::MulAdd(hn::Set(d, columns.per_u), hn::LoadU(d, &t.along_u[i]), x);
    x = hn::MulAdd(hn::Set(d, columns.per_v), hn::LoadU(d, &t.along_v[i]), x);
    x = hn::Min(hn::Max(x, least), most);
    const auto whole = hn::ConvertTo(di, x);
    const auto f = hn::Sub(x, hn::ConvertTo(d, whole));
    const auto at = hn::Add(hn::Mul(hn::LoadU(di, &t.row[i]), hn::Set(di, width)), whole);
    const auto p0 = hn::GatherIndex(d, image - 1, at);
    const auto p1 = hn::GatherIndex(d, image, at);
    const auto p2 = hn::GatherIndex(d, image + 1, at);
    const auto p3 = hn::GatherIndex(d, image + 2, at);
    // p1 + f/2 ((p2 - p0) + f ((2 p0 - 5 p1 + 4 p2 - p3) + f (3 (p1 - p2) + p3 - p0)))
    const auto cubic = hn::MulAdd(hn::Set(d, 3.0F), hn::Sub(p1, p2), hn::Sub(p3, p0));
    auto square = hn::MulAdd(hn::Set(d, 4.0F), p2, hn::Sub(hn::Add(p0, p0), p3));
    square = hn::NegMulAdd(hn::Set(d, 5.0F), p1, square);
    const auto slope = hn::MulAdd(f, hn::MulAdd(f, cubic, square), hn::Sub(p2, p0));
    hn::StoreU(hn::MulAdd(hn::Mul(half, f), slope, p1), d, warped + i);
  }
}

ResidualSums SumResiduals(const PlaneTemplate& t, const float* warped, float gain, float offset, float rising,
                          float* residual) {
  const Floats d;
  auto of_centre = hn::Zero(d);
  auto of_u = hn::Zero(d);
  auto of_v = hn::Zero(d);
  auto of_gain = hn::Zero(d);
  auto of_offset = hn::Zero(d);
  auto of_rising = hn::Zero(d);
  auto squares = hn::Zero(d);
  for (std::size_t i = 0; i < t.padded(); i += hn::Lanes(d)) {
    const auto grey = hn::LoadU(d, &t.grey[i]);
    const auto gradient_v = hn::LoadU(d, &t.gradient_v[i]);
    auto r = hn::Sub(hn::LoadU(d, warped + i), hn::Set(d, offset));
    r = hn::NegMulAdd(hn::Set(d, gain), grey, r);
    r = hn::NegMulAdd(hn::Set(d, rising), gradient_v, r);
    hn::StoreU(r, d, residual + i);
    r = hn::Mul(r, hn::LoadU(d, &t.weight[i]));
    const auto product = hn::Mul(hn::LoadU(d, &t.gradient_u[i]), r);
    of_centre = hn::Sub(of_centre, product);
    of_u = hn::NegMulAdd(product, hn::LoadU(d, &t.along_u[i]), of_u);
    of_v = hn::NegMulAdd(product, hn::LoadU(d, &t.along_v[i]), of_v);
    of_gain = hn::NegMulAdd(grey, r, of_gain);
    of_offset = hn::Sub(of_offset, r);
    of_rising = hn::NegMulAdd(gradient_v, r, of_rising);
    squares = hn::MulAdd(r, r, squares);
  }
  ResidualSums sums;
  sums.products = {sum_of(of_centre), sum_of(of_u),      sum_of(of_v),
                   sum_of(of_gain),   sum_of(of_offset), sum_of(of_rising)};
  sums.squares = sum_of(squares);
  return sums;
}

DerivativeSums SumDerivatives(const PlaneTemplate& t) {
  const Floats d;
  // The derivatives of a block of pixels: six with Sobel's gradient, then three with the plain difference.
  constexpr std::size_t kRows = kPlaneParameters + 3;
  decltype(hn::Zero(d)) sums[kPlaneParameters][kRows];
  for (auto& row : sums) {
    for (auto& sum : row) sum = hn::Zero(d);
  }
  for (std::size_t i = 0; i < t.padded(); i += hn::Lanes(d)) {
    const auto weight = hn::LoadU(d, &t.weight[i]);
    const auto u = hn::LoadU(d, &t.along_u[i]);
    const auto v = hn::LoadU(d, &t.along_v[i]);
    const auto gradient = hn::Neg(hn::Mul(weight, hn::LoadU(d, &t.gradient_u[i])));
    const auto slope = hn::Neg(hn::Mul(weight, hn::LoadU(d, &t.slope_u[i])));
    const decltype(hn::Zero(d)) rows[kRows] = {gradient,
                                               hn::Mul(gradient, u),
                                               hn::Mul(gradient, v),
                                               hn::Neg(hn::Mul(weight, hn::LoadU(d, &t.grey[i]))),
                                               hn::Neg(weight),
                                               hn::Neg(hn::Mul(weight, hn::LoadU(d, &t.gradient_v[i]))),
                                               slope,
                                               hn::Mul(slope, u),
                                               hn::Mul(slope, v)};
    for (std::size_t a = 0; a < kPlaneParameters; ++a) {
      for (std::size_t b = a; b < kRows; ++b) sums[a][b] = hn::MulAdd(rows[a], rows[b], sums[a][b]);
    }
  }
  DerivativeSums result;
  for (std::size_t a = 0; a < kPlaneParameters; ++a) {
    for (std::size_t b = a; b < kPlaneParameters; ++b) {
      result.information[a][b] = result.information[b][a] = sum_of(sums[a][b]);
    }
    for (std::size_t b = 0; b < 3; ++b) result.cross[a][b] = sum_of(sums[a][kPlaneParameters + b]);
  }
  return result;
}

}  // namespace markservo::target_locator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::target_locator {

HWY_EXPORT(SampleRows);
HWY_EXPORT(SumResiduals);
HWY_EXPORT(SumDerivatives);

void sample_rows(const float* image, int width, const PlaneTemplate& t, const ColumnMap& columns, float* warped) {
  HWY_DYNAMIC_DISPATCH(SampleRows)(image, width, t, columns, warped);
}

ResidualSums sum_residuals(const PlaneTemplate& t, const float* warped, float gain, float offset, float rising,
                           float* residual) {
  return HWY_DYNAMIC_DISPATCH(SumResiduals)(t, warped, gain, offset, rising, residual);
}

DerivativeSums sum_derivatives(const PlaneTemplate& t) {
  return HWY_DYNAMIC_DISPATCH(SumDerivatives)(t);
}

}  // namespace markservo::target_locator
#endif  // HWY_ONCE
