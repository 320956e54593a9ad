#pragma once

// Where pixels are, and how they are spread.

#include "services/mark-detector/blobs/pixel_run.hpp"

namespace markservo::mark_detector {

// Px of the image. Moments are about the centroid.
struct Shape {
  int x = 0;  // box: left column
  int y = 0;  // box: top row
  int width = 0;
  int height = 0;
  double area = 0.0;  // px^2
  double u = 0.0;     // centroid
  double v = 0.0;
  double m_uu = 0.0;  // px^2, second moments
  double m_uv = 0.0;
  double m_vv = 0.0;
};

// The shape of what the runs cover; they must not overlap. All zero for none.
Shape shape_of(RunSpan runs);

// True if the box touches the image's border, so that part of the mark may be outside.
bool is_clipped(const Shape& shape, int image_width, int image_height);

}  // namespace markservo::mark_detector
