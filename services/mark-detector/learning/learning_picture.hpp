#pragma once

#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

// A picture and the box in it where a mark is, px, inside the picture.
struct LearningPicture {
  ImageView image;
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

}  // namespace markservo::mark_detector
