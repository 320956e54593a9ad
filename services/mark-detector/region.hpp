#pragma once

// A window of the image around one mark, a byte per pixel: for work on its outline.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "services/mark-detector/blobs.hpp"

namespace markservo::mark_detector {

struct Region {
  int x = 0;  // px of the image, left column
  int y = 0;  // px of the image, top row
  int width = 0;
  int height = 0;
  std::vector<uint8_t> inside;  // 1 where the mark is, row by row

  // Coordinates of the image; outside the window nothing is inside.
  bool test(int u, int v) const {
    if (u < x || v < y || u >= x + width || v >= y + height) return false;
    return inside[index(u - x, v - y)] != 0;
  }
  // Coordinates of the window.
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
  }
};

// The runs' box widened by `margin` px, as far as the image reaches. Empty for no runs.
Region make_region(const std::vector<PixelRun>& runs, int margin, int image_width, int image_height);

// How far a pixel of the window is from the mark's outline.
enum class Depth : uint8_t {
  kOutside,    // further than the band from every pixel of the mark
  kOuterBand,  // not in the mark, within the band
  kInnerBand,  // in the mark, within the band of a pixel that is not
  kInside,     // in the mark, further
};

// The depth of each pixel of the window, with a band of `band` px (chessboard distance) on either side. Beyond the
// window's border nothing is known, so the border itself makes no outline.
std::vector<Depth> depths(const Region& region, int band);

}  // namespace markservo::mark_detector
