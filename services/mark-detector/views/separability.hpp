#pragma once

#include "services/mark-detector/blobs/region.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

// How far the mark's colour stands off from what is around it, 0 (not at all) to 1: Otsu's ratio of the variance
// between two classes to the total variance, with equal weights, of chromaticity (R - G, G - B) projected on the line
// between the classes' means. The classes are the mark and the rest of a window a quarter of the mark's size wider
// (at least 8 px) on each side; blended pixels along the outline count for neither. 0 if there is no such rest. Looks
// at some of the rows.
class SeparabilityMeter {
 public:
  // The margin that the window around a mark of that shape needs, px.
  static int margin(const Shape& shape);

  // `mark`: in a window with that margin. Keeps its memory from mark to mark.
  double measure(const ImageView& image, const Region& mark);

 private:
  BitMask inside_;
  BitMask outside_;
};

}  // namespace markservo::mark_detector
