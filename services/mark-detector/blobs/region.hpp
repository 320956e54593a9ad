#pragma once

// A window of the image around one mark.

#include "common/imaging/bit_mask.hpp"
#include "services/mark-detector/blobs/pixel_run.hpp"
#include "services/mark-detector/blobs/shape.hpp"

namespace markservo::mark_detector {

using imaging::BitMask;

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

// The box of the runs' shape, widened by `margin` px as far as the image reaches. `region` keeps its memory. Empty for
// no runs.
void make_region(RunSpan runs, const Shape& shape, int margin, int image_width, int image_height, Region& region);

}  // namespace markservo::mark_detector
