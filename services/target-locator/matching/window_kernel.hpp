#pragma once

// The loops over one feature's window, in vector code (Highway). Last bits depend on the processor's instruction set.

#include <array>
#include <cstdint>

#include "services/target-locator/image/stereo_patch.hpp"

namespace markservo::target_locator {

// Left pixels about a feature, up to 2 * half_window + 1 <= 15 along each axis.
struct WindowFrame {
  static constexpr int kLanes = PlaneImage::kRoom;
  static constexpr int kLargestHalf = (kLanes - 2) / 2;

  int column = 0;  // patch px, of the first pixels
  int row = 0;
  int height = 0;                            // rows
  float du = 0.0F;                           // image px from the feature to the first pixel
  float dv = 0.0F;                           // image px
  float scale = 1.0F;                        // image px per patch px
  std::array<std::uint16_t, kLanes> used{};  // of each row: a bit a column
};

// Sums over the used pixels; greys less `about`. Moments of q: of q (1, du, dv, du^2, du dv, dv^2).
using WindowMoments = std::array<float, 6>;
struct WindowSums {
  float n = 0.0F;
  float grey = 0.0F;
  float grey_squares = 0.0F;
  WindowMoments gradient{};       // of Sobel's gradient along u, per image px; the first three
  WindowMoments gradient_grey{};  // of its product with the grey; the first three
  WindowMoments newton{};         // of its product with the plain central difference
  WindowMoments information{};    // of its square
};
WindowSums sum_window(const PlaneImage& left, const PlaneImage& gradient, const WindowFrame& window, float about);

// The right view in each window row at column = base + per_u du + per_v dv (patch px), less `about`: sums over the used
// pixels of it, its square, its product with the left grey less `about`, and the gradient's moments with it.
struct RightColumns {
  float base = 0.0F;
  float per_u = 1.0F;
  float per_v = 0.0F;
};
struct ComparisonSums {
  float right = 0.0F;
  float squares = 0.0F;
  float product = 0.0F;
  WindowMoments gradient_right{};  // the first three
};
ComparisonSums compare_window(const PlaneImage& left, const PlaneImage& gradient, const PlaneImage& right_rows,
                              const WindowFrame& window, const RightColumns& columns, float about);

}  // namespace markservo::target_locator
