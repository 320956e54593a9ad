#pragma once

// The pixels that a mark's colour is learned from: of its box, and of what is around the box.

#include <cstddef>
#include <vector>

#include "services/mark-detector/learning/learning_picture.hpp"

namespace markservo::mark_detector {

struct LearningPixel {
  double hue_deg = 0.0;
  double saturation = 0.0;  // as photographed, [0, 1]
  double chroma = 0.0;      // levels
  double level = 0.0;       // of the brightest channel as photographed
  double luma = 0.0;        // levels, as photographed
  double value = 0.0;       // equalised, of 1
  double x = 0.0;           // (R - G) / V and (G - B) / V: chromaticity that is not torn at a hue, and steady at grey
  double y = 0.0;
  double middle = 0.0;  // 1 in the middle of the box, 0 at its edges and outside
  bool in_box = false;
  std::size_t picture = 0;  // its number
  double area = 1.0;        // px of the picture that it stands for
  double mark_share = 0.0;  // [0, 1], how surely it shows the mark (mark_share.hpp)
};

struct LearningPixelParameters {
  double gap_share = 0.1;     // of the box's edge, left out around it: blur, and what a box drawn by hand cuts off
  int gap_least = 2;          // px
  double reach_share = 0.75;  // of the box's edge, how far its surroundings go: seven times the box's area
  double most = 200'000.0;    // pixels a picture; of more, every second or third row and column
};

// All pixels of the pictures' boxes, then all of their surroundings within the pictures, without mark shares.
// `equalise`: value as the detector that equalises sees it.
std::vector<LearningPixel> learning_pixels(const std::vector<LearningPicture>& pictures, bool equalise,
                                           const LearningPixelParameters& parameters = {});

}  // namespace markservo::mark_detector
