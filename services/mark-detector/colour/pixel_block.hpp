#pragma once

// Pixels for loops that take a mask's word at a time.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "common/imaging/bit_mask.hpp"

namespace markservo::mark_detector {

inline constexpr int kBlock = imaging::BitMask::kWordBits;  // pixels

using PixelBlock = std::array<std::uint8_t, std::size_t{3} * kBlock>;  // 8-bit BGR

// A copy in `block` of the last `count` pixels of a row, fewer than a block's, black behind them; the pixels to work
// on.
inline const std::uint8_t* pad_block(const std::uint8_t* bgr, int count, PixelBlock& block) {
  block.fill(0);
  std::copy_n(bgr, 3 * static_cast<std::size_t>(count), block.begin());
  return block.data();
}

}  // namespace markservo::mark_detector
