#include "services/target-locator/plane/plane_kernel.hpp"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/target-locator/plane/plane_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

#include "services/target-locator/image/row_sampler-inl.h"

HWY_BEFORE_NAMESPACE();
namespace markservo::target_locator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
double sum_of(V lanes) {
  const Floats d;
  HWY_ALIGN float values[PlaneTemplate::kLanes];
  hn::Store(lanes, d, values);
  double sum = 0.0;
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) sum += static_cast<double>(values[i]);
  return sum;
}

// What the blocks hold; their greys about the mean, so that gain and offset do not fight each other.
void FillTemplate(const StereoPatch& patch, const TemplateScale& scale, PlaneTemplate& t) {
  const Floats d;
  const auto inverse_scale = hn::Set(d, static_cast<float>(1.0 / patch.left_frame.scale));
  const auto half_inverse = hn::Mul(hn::Set(d, 0.5F), inverse_scale);
  const auto per_pixel = hn::Set(d, static_cast<float>(scale.per_pixel));
  const auto centre = hn::Set(d, static_cast<float>(scale.centre_column));
  auto sum = hn::Zero(d);
  std::size_t i = 0;
  for (const PlaneTemplate::Block& block : t.blocks) {
    const float* grey = patch.left.row(block.row) + block.column;
    const float* gradient_u = patch.left_gradients.column.row(block.row) + block.column;
    const float* gradient_v = patch.left_gradients.row.row(block.row) + block.column;
    const auto v = hn::Set(d, static_cast<float>((block.row - scale.centre_row) * scale.per_pixel));
    for (std::size_t lane = 0; lane < PlaneTemplate::kLanes; lane += hn::Lanes(d), i += hn::Lanes(d)) {
      const auto weight = hn::LoadU(d, &t.weight[i]);
      const auto used = hn::Gt(weight, hn::Zero(d));
      const auto value = hn::IfThenElseZero(used, hn::LoadU(d, grey + lane));
      sum = hn::Add(sum, value);
      hn::StoreU(value, d, &t.grey[i]);
      hn::StoreU(hn::IfThenElseZero(used, hn::Mul(inverse_scale, hn::LoadU(d, gradient_u + lane))), d,
                 &t.gradient_u[i]);
      hn::StoreU(hn::IfThenElseZero(used, hn::Mul(inverse_scale, hn::LoadU(d, gradient_v + lane))), d,
                 &t.gradient_v[i]);
      const auto difference = hn::Sub(hn::LoadU(d, grey + lane + 1), hn::LoadU(d, grey + lane - 1));
      hn::StoreU(hn::IfThenElseZero(used, hn::Mul(half_inverse, difference)), d, &t.slope_u[i]);
      const auto column = hn::Iota(d, static_cast<float>(block.column) + static_cast<float>(lane));
      hn::StoreU(hn::IfThenElseZero(used, hn::Mul(per_pixel, hn::Sub(column, centre))), d, &t.along_u[i]);
      hn::StoreU(hn::IfThenElseZero(used, v), d, &t.along_v[i]);
    }
  }
  t.mean_grey = sum_of(sum) / static_cast<double>(t.count);
  const auto mean = hn::Set(d, static_cast<float>(t.mean_grey));
  for (i = 0; i < t.padded(); i += hn::Lanes(d)) {
    hn::StoreU(hn::NegMulAdd(mean, hn::LoadU(d, &t.weight[i]), hn::LoadU(d, &t.grey[i])), d, &t.grey[i]);
  }
}

void SampleRows(const PlaneImage& image, const PlaneTemplate& t, const ColumnMap& columns, float* warped) {
  const Floats d;
  const auto step = static_cast<float>(columns.per_column);
  for (const PlaneTemplate::Block& block : t.blocks) {
    const float* row = image.row(block.row);
    const auto x0 = static_cast<float>(columns.base + columns.per_column * block.column + columns.per_row * block.row);
    for (std::size_t lane = 0; lane < PlaneTemplate::kLanes; lane += hn::Lanes(d)) {
      hn::StoreU(sample_row(row, image.width, x0 + step * static_cast<float>(lane), step), d, warped);
      warped += hn::Lanes(d);
    }
  }
}

ProductSums SumProducts(const PlaneTemplate& t, const float* warped) {
  const Floats d;
  auto n = hn::Zero(d);
  auto a = hn::Zero(d);
  auto b = hn::Zero(d);
  auto aa = hn::Zero(d);
  auto ab = hn::Zero(d);
  auto bb = hn::Zero(d);
  for (std::size_t i = 0; i < t.padded(); i += hn::Lanes(d)) {
    const auto weight = hn::LoadU(d, &t.weight[i]);
    const auto left = hn::Mul(weight, hn::LoadU(d, &t.grey[i]));
    const auto right = hn::Mul(weight, hn::LoadU(d, warped + i));
    n = hn::Add(n, weight);
    a = hn::Add(a, left);
    b = hn::Add(b, right);
    aa = hn::MulAdd(left, left, aa);
    ab = hn::MulAdd(left, right, ab);
    bb = hn::MulAdd(right, right, bb);
  }
  return {sum_of(n), sum_of(a), sum_of(b), sum_of(aa), sum_of(ab), sum_of(bb)};
}

AbsoluteMean MeanAbsolute(const PlaneTemplate& t, const float* residual, float limit) {
  const Floats d;
  auto n = hn::Zero(d);
  auto sum = hn::Zero(d);
  for (std::size_t i = 0; i < t.padded(); i += hn::Lanes(d)) {
    const auto size = hn::Abs(hn::LoadU(d, residual + i));
    const auto weight = hn::IfThenElseZero(hn::Le(size, hn::Set(d, limit)), hn::LoadU(d, &t.weight[i]));
    n = hn::Add(n, weight);
    sum = hn::MulAdd(weight, size, sum);
  }
  AbsoluteMean result;
  result.n = sum_of(n);
  result.mean = result.n > 0.0 ? sum_of(sum) / result.n : 0.0;
  return result;
}

std::size_t DropAbove(const float* residual, float limit, PlaneTemplate& t) {
  const Floats d;
  auto n = hn::Zero(d);
  for (std::size_t i = 0; i < t.padded(); i += hn::Lanes(d)) {
    const auto kept = hn::Le(hn::Abs(hn::LoadU(d, residual + i)), hn::Set(d, limit));
    const auto weight = hn::IfThenElseZero(kept, hn::LoadU(d, &t.weight[i]));
    hn::StoreU(weight, d, &t.weight[i]);
    n = hn::Add(n, weight);
  }
  return static_cast<std::size_t>(sum_of(n));
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

// The derivatives of a block of pixels: six with Sobel's gradient, then three with the plain difference, which are only
// multiplied by the six.
constexpr std::size_t kPartners = 3;

// Adds the products of `row` with itself and with the rows after it to as many sums, of kLanes each. In memory, for
// they are more than there are registers, and vectors whose length shows at run time (SVE) cannot be an array's
// elements.
template <class V, class... Rows>
HWY_INLINE float* add_products_of(float* sums, V row, Rows... after) {
  const Floats d;
  const auto add = [&](V other) {
    hn::Store(hn::MulAdd(row, other, hn::Load(d, sums)), d, sums);
    sums += PlaneTemplate::kLanes;
  };
  add(row);
  (add(after), ...);
  return sums;
}

// The same of each row but the partners: sums row by row.
template <class V, class... Rows>
HWY_INLINE void add_products(float* sums, V row, Rows... after) {
  sums = add_products_of(sums, row, after...);
  if constexpr (sizeof...(after) > kPartners) add_products(sums, after...);
}

DerivativeSums SumDerivatives(const PlaneTemplate& t) {
  const Floats d;
  constexpr std::size_t kSums = kPlaneParameters * (kPlaneParameters + 1) / 2 + kPlaneParameters * kPartners;
  HWY_ALIGN float sums[kSums * PlaneTemplate::kLanes] = {};
  for (std::size_t i = 0; i < t.padded(); i += hn::Lanes(d)) {
    const auto weight = hn::LoadU(d, &t.weight[i]);
    const auto u = hn::LoadU(d, &t.along_u[i]);
    const auto v = hn::LoadU(d, &t.along_v[i]);
    const auto gradient = hn::Neg(hn::Mul(weight, hn::LoadU(d, &t.gradient_u[i])));
    const auto slope = hn::Neg(hn::Mul(weight, hn::LoadU(d, &t.slope_u[i])));
    add_products(sums, gradient, hn::Mul(gradient, u), hn::Mul(gradient, v),
                 hn::Neg(hn::Mul(weight, hn::LoadU(d, &t.grey[i]))), hn::Neg(weight),
                 hn::Neg(hn::Mul(weight, hn::LoadU(d, &t.gradient_v[i]))), slope, hn::Mul(slope, u), hn::Mul(slope, v));
  }
  DerivativeSums result;
  const float* sum = sums;
  const auto next = [&] {
    const double of_lanes = sum_of(hn::Load(d, sum));
    sum += PlaneTemplate::kLanes;
    return of_lanes;
  };
  for (std::size_t a = 0; a < kPlaneParameters; ++a) {
    for (std::size_t b = a; b < kPlaneParameters; ++b) result.information[a][b] = result.information[b][a] = next();
    for (std::size_t b = 0; b < kPartners; ++b) result.cross[a][b] = next();
  }
  return result;
}

}  // namespace markservo::target_locator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::target_locator {

HWY_EXPORT(FillTemplate);
HWY_EXPORT(SampleRows);
HWY_EXPORT(SumProducts);
HWY_EXPORT(MeanAbsolute);
HWY_EXPORT(DropAbove);
HWY_EXPORT(SumResiduals);
HWY_EXPORT(SumDerivatives);

void fill_template(const StereoPatch& patch, const TemplateScale& scale, PlaneTemplate& t) {
  for (auto* values : {&t.along_u, &t.along_v, &t.grey, &t.gradient_u, &t.gradient_v, &t.slope_u}) {
    values->resize(t.padded());
  }
  HWY_DYNAMIC_DISPATCH(FillTemplate)(patch, scale, t);
}

void sample_rows(const PlaneImage& image, const PlaneTemplate& t, const ColumnMap& columns, float* warped) {
  HWY_DYNAMIC_DISPATCH(SampleRows)(image, t, columns, warped);
}

ProductSums sum_products(const PlaneTemplate& t, const float* warped) {
  return HWY_DYNAMIC_DISPATCH(SumProducts)(t, warped);
}

AbsoluteMean mean_absolute(const PlaneTemplate& t, const float* residual, float limit) {
  return HWY_DYNAMIC_DISPATCH(MeanAbsolute)(t, residual, limit);
}

std::size_t drop_above(const float* residual, float limit, PlaneTemplate& t) {
  return HWY_DYNAMIC_DISPATCH(DropAbove)(residual, limit, t);
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
