#pragma once

// How much of a pixel a blurred shape covers.

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
  double by_blur = 0.0;                                 // d share / d blur
  std::array<double, kMostShapeParameters> by_shape{};  // d share / d each parameter of the shape
};

// The share of a pixel whose middle lies at `distance` (px, positive inside) from a straight edge: the edge blurred by
// a Gaussian of `sigma` px, above 0, averaged over the pixel's width.
struct BlurredEdge {
  double share = 0.0;
  double by_distance = 0.0;  // d share / d distance
  double by_blur = 0.0;      // d share / d sigma

  BlurredEdge(double distance, double sigma) {
    constexpr double kBeyond = 5.0;  // sigmas, where nothing is left of the edge
    const double ahead = (distance + 0.5) / sigma;
    const double behind = (distance - 0.5) / sigma;
    if (!(ahead > -kBeyond && behind < kBeyond)) {
      share = behind > 0.0 ? 1.0 : 0.0;
      return;
    }
    const double normal = 1.0 / std::sqrt(2.0 * M_PI);
    const double density_ahead = normal * std::exp(-0.5 * ahead * ahead);
    const double density_behind = normal * std::exp(-0.5 * behind * behind);
    const double covered_ahead = 0.5 * std::erfc(-ahead * M_SQRT1_2);
    const double covered_behind = 0.5 * std::erfc(-behind * M_SQRT1_2);
    by_distance = covered_ahead - covered_behind;
    by_blur = density_ahead - density_behind;
    share = sigma * (ahead * covered_ahead - behind * covered_behind + by_blur);
  }
};

}  // namespace markservo::target_locator
