#pragma once

// Cameras that deliver both views in one picture, the left view in its left half.

#include <opencv2/core.hpp>
#include <optional>

namespace markservo::stereo_camera {

struct Halves {
  cv::Mat left;
  cv::Mat right;
};

// Both halves as views into `image`; nothing where its width is odd or below 2 px.
std::optional<Halves> split_side_by_side(const cv::Mat& image);

}  // namespace markservo::stereo_camera
