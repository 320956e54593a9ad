// Every vector instruction set that this processor has agrees with the plain definition,
// to rounding.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "services/target-locator/image/epipolar_rows.hpp"
#include "services/target-locator/image/image_kernel.hpp"
#include "services/target-locator/matching/window_kernel.hpp"
#include "services/target-locator/plane/plane_kernel.hpp"
#include "tests/unit/vector_target.hpp"

namespace markservo::target_locator {
namespace {

class VectorTarget : public test::VectorTargetTest {
 protected:
  std::vector<std::uint8_t> bytes(std::size_t count, int most) {
    std::uniform_int_distribution<int> level(0, most);
    std::vector<std::uint8_t> result(count);
    for (auto& byte : result) byte = static_cast<std::uint8_t>(level(random_));
    return result;
  }

  // Blocks somewhere in an image of that size, every fifth pixel not used.
  PlaneTemplate pixels(std::size_t num_blocks, int width, int height) {
    std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
    std::uniform_int_distribution<int> column(0, width - 1);
    std::uniform_int_distribution<int> row(0, height - 1);
    PlaneTemplate t;
    for (std::size_t i = 0; i < num_blocks; ++i) t.blocks.push_back({column(random_), row(random_)});
    for (auto* values : {&t.along_u, &t.along_v, &t.grey, &t.gradient_u, &t.gradient_v, &t.slope_u, &t.weight}) {
      values->resize(t.padded());
      for (float& value : *values) value = unit(random_);
    }
    for (std::size_t i = 0; i < t.padded(); ++i) t.weight[i] = i % 5 == 0 ? 0.0F : 1.0F;
    t.count = t.padded();
    return t;
  }

  PlaneImage image(int width, int height) {
    std::uniform_real_distribution<float> grey(0.0F, 255.0F);
    PlaneImage result(width, height, NAN);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) result.at(x, y) = grey(random_);
    }
    return result;
  }

  std::mt19937 random_{5};
};

TEST_P(VectorTarget, ProjectsPixels) {
  const ColourMap map{{0.3F, -0.7F, 0.65F}, 4.0F};
  constexpr int kHeight = 3;
  for (const int width : {1, 3, 15, 16, 17, 100, 127}) {
    const auto count = static_cast<std::size_t>(width * kHeight);
    const std::vector<std::uint8_t> bgr = bytes(3 * count, 255);
    PlaneImage plane;
    project_pixels(bgr.data(), width, kHeight, map, plane);
    for (std::size_t i = 0; i < count; ++i) {
      const float expected = map.offset + map.weights[0] * static_cast<float>(bgr[3 * i]) +
                             map.weights[1] * static_cast<float>(bgr[3 * i + 1]) +
                             map.weights[2] * static_cast<float>(bgr[3 * i + 2]);
      const int at = static_cast<int>(i);
      ASSERT_NEAR(plane.at(at % width, at / width), expected, 1e-3F) << i << " of " << count;
    }
  }
}

TEST_P(VectorTarget, SamplesRowsAsTheCubicDoes) {
  constexpr int kWidth = 37;
  const PlaneImage grey = image(kWidth, 11);
  const PlaneTemplate t = pixels(40, kWidth, 11);
  // Beyond both ends too; finer, and coarser than two vectors of the row hold.
  for (const ColumnMap map :
       {ColumnMap{-3.0, 1.1, -0.5}, ColumnMap{20.0, 0.6, 0.3}, ColumnMap{-9.0, 2.5, 0.1}, ColumnMap{30.0, -0.4, 0.0}}) {
    std::vector<float> warped(t.padded());
    sample_rows(grey, t, map, warped.data());
    for (std::size_t i = 0; i < t.padded(); ++i) {
      const PlaneTemplate::Block& block = t.blocks[i / PlaneTemplate::kLanes];
      const double x = map.base + map.per_column * (block.column + static_cast<double>(i % PlaneTemplate::kLanes)) +
                       map.per_row * block.row;
      ASSERT_NEAR(warped[i], sample_cubic(grey.row(block.row), kWidth, static_cast<float>(x)), 0.02F)
          << "at column " << x;
    }
  }
}

TEST_P(VectorTarget, ComparesWindowsAsTheDefinitionSays) {
  constexpr int kWidth = 40;
  constexpr int kHeight = 30;
  const PlaneImage left = image(kWidth, kHeight);
  const PlaneImage gradient = image(kWidth, kHeight);
  const PlaneImage right = image(kWidth, kHeight);
  WindowFrame window{12, 7, 13, -14.0F, -10.0F, 2.0F, {}};
  for (auto& bits : window.used) bits = static_cast<std::uint16_t>(random_() & 0x7FFFU);
  constexpr float kAbout = 120.0F;
  const RightColumns columns{15.0F, 0.55F, 0.03F};
  const WindowSums sums = sum_window(left, gradient, window, kAbout);
  const ComparisonSums compared = compare_window(left, gradient, right, window, columns, kAbout);
  std::array<double, 3> plain{};
  std::array<double, 3> comparison{};
  std::array<std::array<double, 6>, 4> moments{};
  std::array<double, 3> of_right{};
  for (int j = 0; j < window.height; ++j) {
    for (int i = 0; i < WindowFrame::kLanes; ++i) {
      if (((window.used[static_cast<std::size_t>(j)] >> i) & 1U) == 0) continue;
      const int x = window.column + i;
      const int y = window.row + j;
      const float du = window.du + 2.0F * static_cast<float>(i);
      const float dv = window.dv + 2.0F * static_cast<float>(j);
      const double grey = static_cast<double>(left.at(x, y) - kAbout);
      const double g = static_cast<double>(gradient.at(x, y)) / 2.0;
      const double slope = static_cast<double>(left.at(x + 1, y) - left.at(x - 1, y)) / 4.0;
      const double r = static_cast<double>(
          sample_cubic(right.row(y), kWidth, columns.base + columns.per_u * du + columns.per_v * dv) - kAbout);
      const double u = static_cast<double>(du);
      const double v = static_cast<double>(dv);
      const std::array<double, 6> powers = {1.0, u, v, u * u, u * v, v * v};
      plain[0] += 1.0;
      plain[1] += grey;
      plain[2] += grey * grey;
      comparison[0] += r;
      comparison[1] += r * r;
      comparison[2] += r * grey;
      const std::array<double, 4> weights = {g, g * grey, g * slope, g * g};
      for (std::size_t q = 0; q < 4; ++q) {
        for (std::size_t k = 0; k < 6; ++k) moments[q][k] += weights[q] * powers[k];
      }
      for (std::size_t k = 0; k < 3; ++k) of_right[k] += g * r * powers[k];
    }
  }
  const auto near = [](float value, double expected, double scale) {
    EXPECT_NEAR(static_cast<double>(value), expected, 1e-5 * scale);
  };
  near(sums.n, plain[0], 1.0);
  near(sums.grey, plain[1], 1e5);
  near(sums.grey_squares, plain[2], 1e6);
  near(compared.right, comparison[0], 1e5);
  near(compared.squares, comparison[1], 1e6);
  near(compared.product, comparison[2], 1e6);
  for (std::size_t k = 0; k < 3; ++k) {
    near(sums.gradient[k], moments[0][k], 1e6);
    near(sums.gradient_grey[k], moments[1][k], 1e7);
    near(compared.gradient_right[k], of_right[k], 1e7);
  }
  for (std::size_t k = 0; k < 6; ++k) {
    near(sums.newton[k], moments[2][k], 1e8);
    near(sums.information[k], moments[3][k], 1e8);
  }
}

TEST_P(VectorTarget, FindsWhatIsFarOffTheMean) {
  PlaneTemplate t = pixels(30, 37, 11);
  std::vector<float> residual(t.padded(), 0.5F);
  for (std::size_t i = 0; i < t.padded(); i += 7) residual[i] = -20.0F;
  double n = 0.0;
  for (std::size_t i = 0; i < t.padded(); ++i) n += i % 7 != 0 && i % 5 != 0 ? 1.0 : 0.0;
  const AbsoluteMean mean = mean_absolute(t, residual.data(), 10.0F);
  EXPECT_EQ(mean.n, n);
  EXPECT_NEAR(mean.mean, 0.5, 1e-6);
  EXPECT_EQ(drop_above(residual.data(), 10.0F, t), static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < t.padded(); ++i) ASSERT_EQ(t.weight[i], i % 7 != 0 && i % 5 != 0 ? 1.0F : 0.0F);
}

TEST_P(VectorTarget, SumsResidualsAndDerivativesOfTheUsedPixels) {
  const PlaneTemplate t = pixels(13, 37, 11);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  std::vector<float> warped(t.padded());
  for (auto& value : warped) value = unit(random_);
  constexpr float kGain = 0.9F;
  constexpr float kOffset = 0.2F;
  constexpr float kRising = -0.1F;
  std::array<double, kPlaneParameters> products{};
  double squares = 0.0;
  DerivativeSums expected;
  for (std::size_t i = 0; i < t.padded(); ++i) {
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

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, VectorTarget, test::every_vector_target(), test::vector_target_name);

}  // namespace
}  // namespace markservo::target_locator
