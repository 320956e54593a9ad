#pragma once

// Passes over a patch's pixels, in vector code (Highway). Patches lie row by row without gaps, so that one call does
// all.

#include <array>
#include <cstddef>
#include <cstdint>

namespace markservo::target_locator {

// out[i] = weights . (B, G, R) of pixel i.
void project_pixels(const std::uint8_t* bgr, std::size_t count, const std::array<float, 3>& weights, float* out);

// Of the pixels that are chosen: how many, and the exact sums of their channels and of the channels' products.
struct ColourSums {
  std::int64_t count = 0;
  std::array<std::int64_t, 3> first{};   // b, g, r
  std::array<std::int64_t, 6> second{};  // bb, bg, br, gg, gr, rr
};

// `chosen`: 1 or 0 a pixel.
ColourSums sum_colours(const std::uint8_t* bgr, const std::uint8_t* chosen, std::size_t count);

}  // namespace markservo::target_locator
