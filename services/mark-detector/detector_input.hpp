#pragma once

// What the detector is told of one frame.

#include <optional>

#include "common/geometry/stereo_camera.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

struct Input {
  ImageView left;
  ImageView right;                               // of the left one's size, or empty: a single picture
  std::optional<geometry::StereoCamera> stereo;  // absent: marks' sizes are not checked

  bool single() const { return right.empty(); }
};

}  // namespace markservo::mark_detector
