#pragma once

// Picture files, read and written for an option.

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace markservo::mark_detector {

// The picture in `bytes`, 8-bit BGR; an empty image if they are none.
cv::Mat decode_picture(const std::vector<std::uint8_t>& bytes);

// `option` is what gave the path, for the error. Both throw ConfigurationError.
cv::Mat read_picture(const std::string& option, const std::string& path);
void write_picture(const std::string& option, const std::string& path, const cv::Mat& image);

}  // namespace markservo::mark_detector
