#pragma once

// Sums over an image's pixels, in vector code (Highway); exact, so every target gives the same.

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/imaging/bit_mask.hpp"

namespace markservo::imaging {

// Of pixels of 8-bit BGR: how many, and the sums of their channels and of the channels' products.
struct ColourSums {
  std::int64_t count = 0;
  std::array<std::int64_t, 3> first{};   // b, g, r
  std::array<std::int64_t, 6> second{};  // bb, bg, br, gg, gr, rr

  // Of the mean and the covariance of two channels, 0 blue, 1 green, 2 red. At least one pixel.
  double mean(int channel) const;
  double covariance(int a, int b) const;
};

// Adds those of the pixels whose bit is set, in every `row_step`-th row, 1 or more. `bgr`: the pixel of the mask's
// first bit; rows are `stride` bytes apart.
void add_colours(const std::uint8_t* bgr, std::ptrdiff_t stride, const BitMask& chosen, int row_step, ColourSums& sums);

}  // namespace markservo::imaging
