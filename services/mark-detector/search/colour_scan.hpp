#pragma once

// Which part of an image is searched for which colours.

#include <array>
#include <cstdint>

#include "common/imaging/bit_mask.hpp"
#include "common/robot/robot_description.hpp"
#include "services/mark-detector/blobs/shape.hpp"
#include "services/mark-detector/colour/colour_kernel.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

// Columns [left, right) of rows [top, bottom), px. Begins and ends with a mask's word or the image.
struct ScanWindow {
  int left = 0;
  int right = 0;
  int top = 0;
  int bottom = 0;
};

ScanWindow whole_image(const ImageView& image);

// The box of `shape` and `margin` px around it, as far as the image reaches.
ScanWindow window_around(const Shape& shape, int margin, const ImageView& image);

// True if the box ends where the window does though the image goes on: there may be more of it.
bool reaches_out(const Shape& shape, const ScanWindow& window, const ImageView& image);

// Rules, 1 to 8, and the mask that receives what meets each; masks are of the image's size.
struct ScanRules {
  std::array<FrameRule, robot::kMaxMarks> rules;
  std::array<imaging::BitMask*, robot::kMaxMarks> masks{};
  std::size_t count = 0;

  void add(const FrameRule& rule, imaging::BitMask& mask) {
    rules.at(count) = rule;
    masks.at(count++) = &mask;
  }
};

// Classifies the pixels of the window.
void scan(const ImageView& image, const ScanWindow& window, const LumaShift& shift, const ScanRules& rules);

// Looks at every `row_step`-th row of the image, from `first_row` on: bit k of the answer is set if one of them holds
// at least `least` pixels that meet the k-th rule. Clears the rows that it looked at.
std::uint32_t scan_rows(const ImageView& image, int first_row, int row_step, int least, const LumaShift& shift,
                        const ScanRules& rules);

}  // namespace markservo::mark_detector
