#pragma once

// Pictures as the bytes that a StereoFrame carries.

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace markservo::stereo_camera {

// width * height * 3 bytes, row by row, blue first. `bgr` must be 8-bit colour, else std::invalid_argument.
void encode_raw(const cv::Mat& bgr, std::vector<std::uint8_t>& bytes);

// One JPEG file of `quality` (1 to 100, else std::invalid_argument).
void encode_jpeg(const cv::Mat& bgr, int quality, std::vector<std::uint8_t>& bytes);

}  // namespace markservo::stereo_camera
