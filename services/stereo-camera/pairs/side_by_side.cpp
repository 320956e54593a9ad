#include "services/stereo-camera/pairs/side_by_side.hpp"

namespace markservo::stereo_camera {

std::optional<Halves> split_side_by_side(const cv::Mat& image) {
  if (image.empty() || image.cols < 2 || image.cols % 2 != 0) return std::nullopt;
  const int half = image.cols / 2;
  return Halves{image.colRange(0, half), image.colRange(half, image.cols)};
}

}  // namespace markservo::stereo_camera
