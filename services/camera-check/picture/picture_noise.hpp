#pragma once

// How noisy a picture is, by itself.

#include <opencv2/core.hpp>

namespace markservo::camera_check {

// Sigma of white noise, grey levels, by what remains of the picture without its planes and edges (Immerkaer, Fast noise
// variance estimation, CVIU 64, 1996), as a median, so that texture in part of the picture does not count as noise.
// `grey`: one channel, 8 bit or float, not empty.
double noise_of(const cv::Mat& grey);

}  // namespace markservo::camera_check
