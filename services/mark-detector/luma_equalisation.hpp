#pragma once

// Histogram equalisation of luma, against darkness (paper, vision chain 1).

#include <array>
#include <cstdint>

#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

// Luma of a pixel, 0..255: ITU-R BT.601, rounded as OpenCV's BGR to YCrCb conversion rounds it.
inline int luma(int b, int g, int r) {
  return (1868 * b + 9617 * g + 4899 * r + (1 << 13)) >> 14;
}

using LumaHistogram = std::array<int64_t, 256>;

// Adds the pixels of every `row_step`-th row, 1 or more, to the histogram.
void accumulate(const ImageView& image, LumaHistogram& histogram, int row_step = 1);

// What equalisation adds to a pixel of luma Y: Y'(Y) - Y, levels, -255..255. Added to B, G and R alike, it leaves hue
// as it is.
using LumaShift = std::array<int16_t, 256>;

// All zero: no equalisation.
LumaShift no_shift();

// The shift of the table that cv::equalizeHist would use for this histogram. A histogram of one level or none is left
// as it is.
LumaShift equalising_shift(const LumaHistogram& histogram);

// The shift without what darkens: a mark that is the darkest thing of a bright scene would otherwise drown.
LumaShift against_darkness(const LumaShift& shift);

}  // namespace markservo::mark_detector
