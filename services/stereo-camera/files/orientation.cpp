#include "services/stereo-camera/files/orientation.hpp"

#include <cmath>

namespace markservo::stereo_camera {

Orientation orientation_of(const std::array<std::int32_t, 9>& display_matrix) {
  const double a = display_matrix[0];
  const double b = display_matrix[1];
  const double c = display_matrix[3];
  const double d = display_matrix[4];
  if (std::abs(b) + std::abs(c) > std::abs(a) + std::abs(d)) return {true, c < 0.0, b < 0.0};
  return {false, a < 0.0, d < 0.0};
}

cv::Mat make_upright(const cv::Mat& picture, const Orientation& orientation) {
  cv::Mat turned = picture;
  if (orientation.transpose) cv::transpose(picture, turned);
  if (!orientation.flip_columns && !orientation.flip_rows) return turned.clone();
  const int axis = !orientation.flip_rows ? 1 : !orientation.flip_columns ? 0 : -1;  // as cv::flip numbers them
  cv::Mat upright;
  cv::flip(turned, upright, axis);
  return upright;
}

}  // namespace markservo::stereo_camera
