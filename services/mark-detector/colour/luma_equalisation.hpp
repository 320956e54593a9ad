#pragma once

// Histogram equalisation of luma, against darkness (paper, vision chain 1).

#include <array>
#include <cstdint>

#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

// ITU-R BT.601 as OpenCV's BGR to YCrCb conversion rounds it: shares of B, G and R, of 2^kLumaBits in all.
inline constexpr int kLumaBits = 14;
inline constexpr int kLumaB = 1868;
inline constexpr int kLumaG = 9617;
inline constexpr int kLumaR = 4899;

// Luma of a pixel, 0..255.
inline int luma(int b, int g, int r) {
  return (kLumaB * b + kLumaG * g + kLumaR * r + (1 << (kLumaBits - 1))) >> kLumaBits;
}

using LumaHistogram = std::array<std::int64_t, 256>;

// Adds the pixels of every `row_step`-th row, 1 or more, from `first_row` on, to the histogram.
void accumulate(const ImageView& image, LumaHistogram& histogram, int first_row = 0, int row_step = 1);

// What equalisation adds to a pixel of luma Y: Y'(Y) - Y, levels, -255..255. Added to B, G and R alike, it leaves hue
// as it is.
using LumaShift = std::array<std::int16_t, 256>;

// All zero: no equalisation.
LumaShift no_shift();

// The shift of the table that cv::equalizeHist would use for this histogram. A histogram of one level or none is left
// as it is.
LumaShift equalising_shift(const LumaHistogram& histogram);

// The one for a pair of images (the right one may be empty), from about `rows` rows of each, 1 or more: other rows of
// the right one than of the left.
LumaShift equalising_shift(const ImageView& left, const ImageView& right, int rows);

// How many times brighter than photographed equalisation may make a pixel. A histogram knows order, not light: where
// most of a picture is dark, it would lift black cloth to more than half of white, and a mark's least value would mean
// nothing. 2.5 makes good for 0.4 of the light, the least in which marks must be kept, and leaves black things, which
// reflect a twentieth of what white does, below 0.15.
inline constexpr double kGreatestLift = 2.5;

// The shift without what darkens, for a mark that is the darkest thing of a bright scene would otherwise drown, and
// without what lifts a luma Y above kGreatestLift Y. The brightest channel V is Y or more, so V is lifted no further.
LumaShift against_darkness(const LumaShift& shift);

}  // namespace markservo::mark_detector
