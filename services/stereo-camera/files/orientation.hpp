#pragma once

// How a picture is turned and mirrored before it is shown: cameras write pictures as their sensor lies and say beside
// them which way is up.

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>

namespace markservo::stereo_camera {

// First the picture is mirrored in its diagonal (rows become columns), then its columns, then its rows are reversed.
// Eight cases: four turns, each mirrored or not.
struct Orientation {
  bool transpose = false;
  bool flip_columns = false;
  bool flip_rows = false;
};

// Of the matrix that FFmpeg's libavutil/display.h defines, row by row: a pixel (x, y) of the picture is shown at
// (x m[0] + y m[3], x m[1] + y m[4]) plus a shift. Turns that are no quarter turns count as the nearest.
Orientation orientation_of(const std::array<std::int32_t, 9>& display_matrix);

// `picture` as it is to be shown, in a buffer of its own.
cv::Mat make_upright(const cv::Mat& picture, const Orientation& orientation);

}  // namespace markservo::stereo_camera
