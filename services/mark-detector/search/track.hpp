#pragma once

// The memory of where a mark was.

#include "services/mark-detector/blobs/shape.hpp"
#include "services/mark-detector/views/pair_place.hpp"

namespace markservo::mark_detector {

struct Track {
  bool known = false;
  PairPlace place;
  Shape left;  // as last seen
  Shape right;
  int width = 0;   // px of the images
  int height = 0;  // px
  int age = 0;     // frames since then

  // To be called for each new frame, of images of that size: forgets a place of more than `memory_frames` ago, and one
  // in images of another size.
  void begin_frame(int image_width, int image_height, int memory_frames);

  // Whether both images of the frame before showed the mark.
  bool is_fresh() const { return known && age == 1; }
};

// The memory of a mark that both images of a frame, of that size, show.
Track track_of(const Shape& left, const Shape& right, int image_width, int image_height);

}  // namespace markservo::mark_detector
