#include "services/mark-detector/search/track.hpp"

namespace markservo::mark_detector {

void Track::begin_frame(int image_width, int image_height, int memory_frames) {
  const bool same_size = width == image_width && height == image_height;
  if (known && (++age > memory_frames || !same_size)) known = false;
}

Track track_of(const Shape& left, const Shape& right, int image_width, int image_height) {
  return {true, place_of(left, right), left, right, image_width, image_height, 0};
}

}  // namespace markservo::mark_detector
