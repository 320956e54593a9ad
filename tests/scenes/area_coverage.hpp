#pragma once

// The exact share of every pixel that a polygon covers, and what a lens makes of it.

#include <opencv2/core.hpp>
#include <vector>

namespace markservo::scenes {

// Of each pixel of `pixels` (px of the image, pixel centres at integers) the share that the polygon covers, after a
// Gaussian blur of `blur_px`: integrated over the pixel's square, not sampled. The polygon may turn either way; what
// crosses the rectangle's left and right ends by more than a few pixels is cut off there.
cv::Mat1f blurred_coverage(const std::vector<cv::Point2d>& polygon, const cv::Rect& pixels, double blur_px);

}  // namespace markservo::scenes
