#pragma once

// The loops over a plane's pixels, in vector code (Highway). Sums are taken lane by lane, so that their last bits
// depend on the processor's instruction set.

#include <array>

#include "services/target-locator/plane_template.hpp"

namespace markservo::target_locator {

inline constexpr int kPlaneParameters = 6;

// column = base + per_column t.column + per_u t.along_u + per_v t.along_v, all patch px of the right view.
struct ColumnMap {
  float base = 0.0F;
  float per_column = 0.0F;
  float per_u = 0.0F;
  float per_v = 0.0F;
};

// The greys of `image`, rows of `width` >= 4 pixels, by Catmull-Rom's cubic in each template pixel's row. `warped` has
// t.padded() values.
void sample_rows(const float* image, int width, const PlaneTemplate& t, const ColumnMap& columns, float* warped);

// residual = warped - gain grey - offset - rising gradient_v, t.padded() values, and of the used ones their sum of
// squares and their products with the six derivatives (of disparity at the centre, along u, along v, gain, offset,
// rising).
struct ResidualSums {
  std::array<double, kPlaneParameters> products{};
  double squares = 0.0;
};
ResidualSums sum_residuals(const PlaneTemplate& t, const float* warped, float gain, float offset, float rising,
                           float* residual);

// Sums over the used pixels of the derivatives' products: `information` with Sobel's gradient on both sides (little
// noise), `cross` with the plain difference (the texture's true slope) in its first three columns.
struct DerivativeSums {
  std::array<std::array<double, kPlaneParameters>, kPlaneParameters> information{};
  std::array<std::array<double, 3>, kPlaneParameters> cross{};
};
DerivativeSums sum_derivatives(const PlaneTemplate& t);

}  // namespace markservo::target_locator
