#pragma once

// A mark's surroundings, small enough to send.

#include <cstdint>
#include <vector>

namespace markservo::mark_detector {

// Patch pixel (i, j) averages the image's columns x + i * scale .. x + (i + 1) * scale - 1, rows likewise.
struct Patch {
  int x = 0;
  int y = 0;
  int scale = 0;  // 0: no patch
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bgr;
  std::vector<std::uint8_t> mask;  // a bit a patch pixel, rows padded to bytes, lowest bit first: half or more is mark
};

}  // namespace markservo::mark_detector
