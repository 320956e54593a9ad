// Every vector instruction set that this processor has agrees with the plain definition: integers to the last bit,
// floats to rounding.

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <cmath>
#include <random>
#include <vector>

#include "services/target-locator/epipolar_rows.hpp"
#include "services/target-locator/pixel_kernel.hpp"
#include "services/target-locator/plane_kernel.hpp"

namespace markservo::target_locator {
namespace {

class VectorTarget : public testing::TestWithParam<int64_t> {
 protected:
  VectorTarget() { hwy::SetSupportedTargetsForTest(GetParam()); }
  ~VectorTarget() override { hwy::SetSupportedTargetsForTest(0); }

  std::vector<std::uint8_t> bytes(std::size_t count, int most) {
    std::uniform_int_distribution<int> level(0, most);
    std::vector<std::uint8_t> result(count);
    for (auto& byte : result) byte = static_cast<std::uint8_t>(level(random_));
    return result;
  }

  // `count` pixels, every fifth of them not used.
  PlaneTemplate pixels(std::size_t count, int width, int height) {
    std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
    std::uniform_int_distribution<int> row(0, height - 1);
    PlaneTemplate t;
    t.count = count;
    const std::size_t padded = (count + PlaneTemplate::kLanes - 1) / PlaneTemplate::kLanes * PlaneTemplate::kLanes;
    for (auto* values :
         {&t.column, &t.along_u, &t.along_v, &t.grey, &t.gradient_u, &t.gradient_v, &t.slope_u, &t.weight}) {
      values->resize(padded);
      for (std::size_t i = 0; i < count; ++i) (*values)[i] = unit(random_);
    }
    t.row.resize(padded);
    for (std::size_t i = 0; i < count; ++i) {
      t.row[i] = row(random_);
      t.column[i] = 0.5F * static_cast<float>(width) * (1.0F + t.column[i]);
      t.weight[i] = i % 5 == 0 ? 0.0F : 1.0F;
    }
    return t;
  }

  std::mt19937 random_{5};
};

TEST_P(VectorTarget, ProjectsPixels) {
  const std::array<float, 3> weights{0.3F, -0.7F, 0.65F};
  for (const std::size_t count : {1U, 3U, 15U, 16U, 17U, 100U, 127U}) {
    const std::vector<std::uint8_t> bgr = bytes(3 * count, 255);
    std::vector<float> out(count, NAN);
    project_pixels(bgr.data(), count, weights, out.data());
    for (std::size_t i = 0; i < count; ++i) {
      const float expected = weights[0] * static_cast<float>(bgr[3 * i]) +
                             weights[1] * static_cast<float>(bgr[3 * i + 1]) +
                             weights[2] * static_cast<float>(bgr[3 * i + 2]);
      ASSERT_NEAR(out[i], expected, 1e-4F) << i << " of " << count;
    }
  }
}

TEST_P(VectorTarget, SumsColoursExactly) {
  for (const std::size_t count : {1U, 15U, 16U, 33U, 1000U, 600001U}) {
    // White where it counts most: sums of squares beyond 32 bits.
    const bool white = count > 1000U;
    const std::vector<std::uint8_t> bgr =
        white ? std::vector<std::uint8_t>(3 * count, std::uint8_t{255}) : bytes(3 * count, 255);
    const std::vector<std::uint8_t> chosen = bytes(count, 1);
    ColourSums expected;
    for (std::size_t i = 0; i < count; ++i) {
      if (chosen[i] == 0) continue;
      ++expected.count;
      std::size_t product = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        expected.first[a] += bgr[3 * i + a];
        for (std::size_t b = a; b < 3; ++b) expected.second[product++] += bgr[3 * i + a] * bgr[3 * i + b];
      }
    }
    const ColourSums sums = sum_colours(bgr.data(), chosen.data(), count);
    EXPECT_EQ(sums.count, expected.count);
    EXPECT_EQ(sums.first, expected.first);
    EXPECT_EQ(sums.second, expected.second);
  }
}

TEST_P(VectorTarget, SamplesRowsAsTheCubicDoes) {
  constexpr int kWidth = 37;
  constexpr int kHeight = 11;
  std::uniform_real_distribution<float> grey(0.0F, 255.0F);
  std::vector<float> image(std::size_t{kWidth} * kHeight);
  for (auto& value : image) value = grey(random_);
  const PlaneTemplate t = pixels(203, kWidth, kHeight);
  const ColumnMap map{-3.0F, 1.1F, 2.0F, -1.5F};  // beyond both ends too
  std::vector<float> warped(t.padded());
  sample_rows(image.data(), kWidth, t, map, warped.data());
  for (std::size_t i = 0; i < t.size(); ++i) {
    const float x = map.base + map.per_column * t.column[i] + map.per_u * t.along_u[i] + map.per_v * t.along_v[i];
    const float* row = image.data() + std::ptrdiff_t{kWidth} * t.row[i];
    ASSERT_NEAR(warped[i], sample_cubic(row, kWidth, x), 0.02F) << "at column " << x;
  }
}

TEST_P(VectorTarget, SumsResidualsAndDerivativesOfTheUsedPixels) {
  const PlaneTemplate t = pixels(203, 37, 11);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  std::vector<float> warped(t.padded());
  for (auto& value : warped) value = unit(random_);
  constexpr float kGain = 0.9F;
  constexpr float kOffset = 0.2F;
  constexpr float kRising = -0.1F;
  std::array<double, kPlaneParameters> products{};
  double squares = 0.0;
  DerivativeSums expected;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t.weight[i] == 0.0F) continue;
    const auto r = static_cast<double>(warped[i] - kGain * t.grey[i] - kOffset - kRising * t.gradient_v[i]);
    const double u = static_cast<double>(t.along_u[i]);
    const double v = static_cast<double>(t.along_v[i]);
    const double gradient = -static_cast<double>(t.gradient_u[i]);
    const double slope = -static_cast<double>(t.slope_u[i]);
    const double left[] = {gradient,     gradient * u,
                           gradient * v, -static_cast<double>(t.grey[i]),
                           -1.0,         -static_cast<double>(t.gradient_v[i])};
    const double right[] = {slope, slope * u, slope * v};
    squares += r * r;
    for (std::size_t a = 0; a < kPlaneParameters; ++a) {
      products[a] += left[a] * r;
      for (std::size_t b = 0; b < kPlaneParameters; ++b) expected.information[a][b] += left[a] * left[b];
      for (std::size_t b = 0; b < 3; ++b) expected.cross[a][b] += left[a] * right[b];
    }
  }
  std::vector<float> residual(t.padded());
  const ResidualSums sums = sum_residuals(t, warped.data(), kGain, kOffset, kRising, residual.data());
  const DerivativeSums derivatives = sum_derivatives(t);
  EXPECT_NEAR(sums.squares, squares, 1e-3);
  for (std::size_t a = 0; a < kPlaneParameters; ++a) {
    EXPECT_NEAR(sums.products[a], products[a], 1e-3) << a;
    for (std::size_t b = 0; b < kPlaneParameters; ++b) {
      EXPECT_NEAR(derivatives.information[a][b], expected.information[a][b], 1e-3) << a << " " << b;
    }
    for (std::size_t b = 0; b < 3; ++b)
      EXPECT_NEAR(derivatives.cross[a][b], expected.cross[a][b], 1e-3) << a << " " << b;
  }
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, VectorTarget, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

}  // namespace
}  // namespace markservo::target_locator
