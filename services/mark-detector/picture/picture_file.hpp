#pragma once

// Picture files, read and written for an option.

#include <opencv2/core.hpp>
#include <string>

namespace markservo::mark_detector {

// `option` is what gave the path, for the error. Both throw ConfigurationError.
cv::Mat read_picture(const std::string& option, const std::string& path);
void write_picture(const std::string& option, const std::string& path, const cv::Mat& image);

}  // namespace markservo::mark_detector
