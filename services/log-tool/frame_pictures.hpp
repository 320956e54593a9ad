#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "common/reflection/message_value.hpp"

namespace markservo::log_tool {

struct FramePictures {
  std::string error;  // why there are none; empty when all is well
  cv::Mat left;       // BGR, 8 bit
  cv::Mat right;
};

// The two images of a StereoFrame.
FramePictures pictures_of(const reflection::Fields& frame);

}  // namespace markservo::log_tool
