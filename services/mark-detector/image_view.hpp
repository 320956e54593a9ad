#pragma once

// A colour image that belongs to somebody else.

#include <cstddef>
#include <cstdint>

namespace markservo::mark_detector {

// 8-bit BGR, blue first, rows `stride` bytes apart. Columns u to the right, rows v down, pixel centres at integers.
struct ImageView {
  const std::uint8_t* bgr = nullptr;
  int width = 0;              // px
  int height = 0;             // px
  std::ptrdiff_t stride = 0;  // bytes

  bool empty() const { return bgr == nullptr || width <= 0 || height <= 0; }
  const std::uint8_t* row(int v) const { return bgr + v * stride; }
  const std::uint8_t* pixel(int u, int v) const { return row(v) + 3 * static_cast<std::ptrdiff_t>(u); }
};

}  // namespace markservo::mark_detector
