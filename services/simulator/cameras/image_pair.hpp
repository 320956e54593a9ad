#pragma once

#include <opencv2/core.hpp>

namespace markservo::simulator {

struct ImagePair {
  cv::Mat left;   // CV_8UC3, blue first, rows from the top
  cv::Mat right;  // likewise
};

}  // namespace markservo::simulator
