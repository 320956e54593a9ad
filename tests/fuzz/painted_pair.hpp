#pragma once

// Image pairs from a few bytes: what a fuzzer changes is what is painted where, not single pixels.

#include <fuzzer/FuzzedDataProvider.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace markservo::fuzz {

// One image in memory of exactly its own size, so that reading past a row's or the image's end is noticed.
struct PaintedImage {
  int width = 0;              // px
  int height = 0;             // px
  std::ptrdiff_t stride = 0;  // bytes from row to row, at least 3 * width; the last row ends with its last pixel
  std::vector<std::uint8_t> bgr;
};

struct PaintedPair {
  PaintedImage left;
  PaintedImage right;
};

// Rectangles, checkerboards, speckles and prints in the marks' and other colours, each at a disparity of its own, on a
// grey ground; then the fuzzer's raw bytes over the left image's first pixels. Sides of 1 px or more.
PaintedPair paint_pair(FuzzedDataProvider& data, int width, int height);

}  // namespace markservo::fuzz
