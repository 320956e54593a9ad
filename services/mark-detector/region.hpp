#pragma once

// A window of the image around one mark: for work on its outline.

#include <vector>

#include "services/mark-detector/bit_mask.hpp"
#include "services/mark-detector/blobs.hpp"

namespace markservo::mark_detector {

struct Region {
  int x = 0;  // px of the image, left column
  int y = 0;  // px of the image, top row
  int width = 0;
  int height = 0;
  BitMask inside;  // of the window's size, set where the mark is

  // Coordinates of the image; outside the window nothing is inside.
  bool test(int u, int v) const {
    if (u < x || v < y || u >= x + width || v >= y + height) return false;
    return inside.test(u - x, v - y);
  }
};

// The runs' box widened by `margin` px, as far as the image reaches. Empty for no runs.
Region make_region(const std::vector<PixelRun>& runs, int margin, int image_width, int image_height);

// How far the pixels of a window are from the mark's outline; every one is in one of the three.
struct Depths {
  BitMask inside;   // in the mark, further than the band from every pixel that is not
  BitMask band;     // nearer to the outline than that, on either side
  BitMask outside;  // not in the mark, further than the band from every pixel of it
};

// With a band of `band` px (chessboard distance) on either side. Beyond the window's border nothing is known, so the
// border itself makes no outline.
Depths depths(const Region& region, int band);

}  // namespace markservo::mark_detector
