#pragma once

// How bright a picture is.

#include <opencv2/core.hpp>

namespace markservo::camera_check {

struct PictureLight {
  double bright_level = 0.0;  // that only 5% of the pixels exceed, 0 to 255
  double middle_level = 0.0;  // the median, 0 to 255
  double blown_share = 0.0;   // of the pixels at the end of the scale, 0 to 1: they have lost their colour
};

// Of an 8-bit picture of one channel. A few lamps or a few black corners do not decide.
PictureLight light_of(const cv::Mat& grey);

}  // namespace markservo::camera_check
