#pragma once

// The loops over a plane's pixels, in vector code (Highway). Sums are taken lane by lane, so that their last bits
// depend on the processor's instruction set.

#include <array>

#include "services/target-locator/plane/plane_template.hpp"

namespace markservo::target_locator {

inline constexpr int kPlaneParameters = 6;

// Fills what a template says of its pixels, from its blocks and weights. `centre`: column, row (patch px), and what a
// patch pixel is in the template's extents.
struct TemplateScale {
  double centre_column = 0.0;
  double centre_row = 0.0;
  double per_pixel = 1.0;
};
void fill_template(const StereoPatch& patch, const TemplateScale& scale, PlaneTemplate& t);

// Column of the right view = base + per_column column + per_row row of the left one, all patch px.
struct ColumnMap {
  double base = 0.0;
  double per_column = 1.0;
  double per_row = 0.0;
};

// The greys of `image`, at least 4 pixels wide, by Catmull-Rom's cubic in each template pixel's row. `warped` has
// t.padded() values.
void sample_rows(const PlaneImage& image, const PlaneTemplate& t, const ColumnMap& columns, float* warped);

// Sums over the used pixels of products of a = the template's greys and b = the warped ones.
struct ProductSums {
  double n = 0.0;
  double a = 0.0;
  double b = 0.0;
  double aa = 0.0;
  double ab = 0.0;
  double bb = 0.0;
};
ProductSums sum_products(const PlaneTemplate& t, const float* warped);

// residual = warped - gain grey - offset - rising gradient_v, t.padded() values, and of the used ones their sum of
// squares and their products with the six derivatives (of disparity at the centre, along u, along v, gain, offset,
// rising).
struct ResidualSums {
  std::array<double, kPlaneParameters> products{};
  double squares = 0.0;
};
ResidualSums sum_residuals(const PlaneTemplate& t, const float* warped, float gain, float offset, float rising,
                           float* residual);

// Number and mean of the used pixels' |residual| up to `limit`.
struct AbsoluteMean {
  double n = 0.0;
  double mean = 0.0;
};
AbsoluteMean mean_absolute(const PlaneTemplate& t, const float* residual, float limit);

// Gives pixels whose |residual| is above `limit` weight 0. Returns how many are left.
std::size_t drop_above(const float* residual, float limit, PlaneTemplate& t);

// Sums over the used pixels of the derivatives' products: `information` with Sobel's gradient on both sides (little
// noise), `cross` with the plain difference (the texture's true slope) in its first three columns.
struct DerivativeSums {
  std::array<std::array<double, kPlaneParameters>, kPlaneParameters> information{};
  std::array<std::array<double, 3>, kPlaneParameters> cross{};
};
DerivativeSums sum_derivatives(const PlaneTemplate& t);

}  // namespace markservo::target_locator
