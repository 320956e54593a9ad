#pragma once

// How much of a pixel a blurred shape covers.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace markservo::target_locator {

inline constexpr std::size_t kMostShapeParameters = 8;

// What a pixel shows of a shape, and how that changes with the shape. Patch px.
struct Coverage {
  double distance = 0.0;                                // of the pixel's middle from the outline, positive inside
  double around = 0.0;                                  // which part of the outline is nearest: 0 to 1 once around
  double share = 0.0;                                   // of the pixel that is covered
  double by_distance = 0.0;                             // d share / d distance
  double by_blur = 0.0;                                 // d share / d blur
  std::array<double, kMostShapeParameters> by_shape{};  // d share / d each parameter of the shape
};

// The share of a pixel whose middle lies at `distance` (px, positive inside) from a straight edge of any unit normal:
// the edge blurred by a Gaussian of `sigma` px, above 0, averaged over the pixel's square. Across the edge this square
// is two boxes folded, as wide as the normal's components.
struct BlurredEdge {
  double share = 0.0;
  double by_distance = 0.0;  // d share / d distance
  double by_blur = 0.0;      // d share / d sigma

  BlurredEdge(double distance, double sigma, double normal_x, double normal_y) {
    constexpr double kBeyond = 5.0;  // sigmas, where nothing is left of the edge
    const double wide = std::max(std::abs(normal_x), std::abs(normal_y));
    const double narrow = std::min(std::abs(normal_x), std::abs(normal_y));
    const double outer = 0.5 * (wide + narrow);
    if (!(std::abs(distance) < outer + kBeyond * sigma)) {
      share = distance > 0.0 ? 1.0 : 0.0;
      return;
    }
    constexpr double kOneBox = 0.1;  // px of the narrow one, below which a box of one pixel's width is the same
    if (narrow < kOneBox) {
      add({distance + 0.5, sigma}, 1.0);
      add({distance - 0.5, sigma}, -1.0);
      return;
    }
    const double inner = 0.5 * (wide - narrow);
    const double scale = 1.0 / (wide * narrow);
    add_twice({distance + outer, sigma}, scale);
    add_twice({distance + inner, sigma}, -scale);
    add_twice({distance - inner, sigma}, -scale);
    add_twice({distance - outer, sigma}, scale);
  }

 private:
  // A blurred step at a place, and what makes its integrals.
  struct Step {
    double sigma;
    double t;        // sigmas from the step
    double covered;  // its value
    double density;  // its derivative by t

    Step(double place, double blur)
        : sigma(blur),
          t(place / blur),
          covered(0.5 * std::erfc(-t * M_SQRT1_2)),
          density(std::exp(-0.5 * t * t) / std::sqrt(2.0 * M_PI)) {}
  };
  // Its first integral.
  void add(const Step& at, double factor) {
    share += factor * at.sigma * (at.t * at.covered + at.density);
    by_distance += factor * at.covered;
    by_blur += factor * at.density;
  }
  // Its second integral.
  void add_twice(const Step& at, double factor) {
    share += factor * 0.5 * at.sigma * at.sigma * ((at.t * at.t + 1.0) * at.covered + at.t * at.density);
    by_distance += factor * at.sigma * (at.t * at.covered + at.density);
    by_blur += factor * at.sigma * at.covered;
  }
};

}  // namespace markservo::target_locator
