#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace markservo::bench {

// The sum of all whole 64-bit words of both images, which must be continuous: the least that anything must do that
// looks at every pixel.
std::uint64_t read_once(const cv::Mat& left, const cv::Mat& right);

}  // namespace markservo::bench
