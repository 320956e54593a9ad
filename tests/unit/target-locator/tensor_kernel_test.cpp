// Every vector instruction set that this processor has gives Foerstner's operator as it is defined, also in memory that
// held another image before.

#include "services/target-locator/features/tensor_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/unit/vector_target.hpp"

namespace markservo::target_locator {
namespace {

// Rows and columns beyond the border repeat it.
double grey_at(const PlaneImage& image, int x, int y) {
  return static_cast<double>(image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1)));
}

struct Slope {
  double column = 0.0;
  double row = 0.0;
};

// Sobel's over 8; beyond the image 0.
Slope slope_at(const PlaneImage& image, int x, int y) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return {};
  Slope slope;
  for (int k = -1; k <= 1; ++k) {
    const double weight = k == 0 ? 0.25 : 0.125;
    slope.column += weight * (grey_at(image, x + 1, y + k) - grey_at(image, x - 1, y + k));
    slope.row += weight * (grey_at(image, x + k, y + 1) - grey_at(image, x + k, y - 1));
  }
  return slope;
}

struct Corner {
  double weight = 0.0;
  double roundness = 0.0;
};

Corner corner_at(const PlaneImage& image, int x, int y) {
  double cc = 0.0;
  double cr = 0.0;
  double rr = 0.0;
  double all = 0.0;
  for (int j = -2; j <= 2; ++j) {
    for (int i = -2; i <= 2; ++i) {
      const double gaussian = std::exp(-0.5 * (i * i + j * j));
      const Slope slope = slope_at(image, x + i, y + j);
      all += gaussian;
      cc += gaussian * slope.column * slope.column;
      cr += gaussian * slope.column * slope.row;
      rr += gaussian * slope.row * slope.row;
    }
  }
  const double determinant = (cc * rr - cr * cr) / (all * all);
  const double trace = (cc + rr) / all;
  return trace >= 1.0 ? Corner{determinant / trace, 4.0 * determinant / (trace * trace)} : Corner{};
}

class TensorKernel : public test::VectorTargetTest {};

TEST_P(TensorKernel, FillsGradientsMeasuresAndMaxima) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> level(0, 60);
  Gradients gradients;
  CornerMeasures measures;
  for (const int width : {1, 4, 15, 16, 17, 33, 70}) {
    for (const int height : {1, 5, 11, 12}) {
      PlaneImage image(width, height);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image.at(x, y) = static_cast<float>(level(random));
      }
      sobel_gradients(image, false, gradients);
      foerstner(gradients, 1.0F, measures);
      std::vector<std::uint64_t> inside(static_cast<std::size_t>((width + 63) / 64), ~std::uint64_t{0});
      if (width % 64 != 0) inside.back() = (std::uint64_t{1} << (width % 64)) - 1;
      for (int y = 0; y < height; ++y) {
        std::vector<std::uint64_t> maxima(inside.size());
        constexpr float kLeast = 3.0F;
        find_maxima(measures, y, kLeast, 0.2F, inside.data(), maxima.data());
        for (int x = 0; x < width; ++x) {
          const Slope slope = slope_at(image, x, y);
          ASSERT_NEAR(static_cast<double>(gradients.column.at(x, y)), slope.column, 1e-4) << width << " " << x;
          ASSERT_NEAR(static_cast<double>(gradients.row.at(x, y)), slope.row, 1e-4) << width << " " << x;
          const Corner corner = corner_at(image, x, y);
          ASSERT_NEAR(static_cast<double>(measures.weight.at(x, y)), corner.weight, 1e-3) << width << " " << x;
          ASSERT_NEAR(static_cast<double>(measures.roundness.at(x, y)), corner.roundness, 1e-4) << width << " " << x;
          bool expected = measures.weight.at(x, y) >= kLeast && measures.roundness.at(x, y) >= 0.2F;
          for (int j = -1; j <= 1; ++j) {
            for (int i = -1; i <= 1; ++i) {
              if (x + i < 0 || y + j < 0 || x + i >= width || y + j >= height || (i == 0 && j == 0)) continue;
              const float other = measures.weight.at(x + i, y + j);
              const bool before = j < 0 || (j == 0 && i < 0);
              if (other > measures.weight.at(x, y) || (before && other == measures.weight.at(x, y))) expected = false;
            }
          }
          ASSERT_EQ(((maxima[static_cast<std::size_t>(x / 64)] >> (x % 64)) & 1U) != 0, expected) << x << " " << y;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, TensorKernel, test::every_vector_target(), test::vector_target_name);

}  // namespace
}  // namespace markservo::target_locator
