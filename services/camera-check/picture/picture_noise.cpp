#include "services/camera-check/picture/picture_noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace markservo::camera_check {
namespace {

double median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double noise_of(const cv::Mat& grey) {
  const cv::Mat kernel = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  constexpr double kOfKernel = 6.0;        // the root of the sum of its squares
  constexpr double kOfNormal = 0.6744898;  // the median of |x| of a normal distribution with sigma 1
  cv::Mat rest;
  cv::filter2D(grey, rest, CV_32F, kernel);
  std::vector<float> values(rest.begin<float>(), rest.end<float>());
  for (float& value : values) value = std::abs(value);
  return median(values) / (kOfKernel * kOfNormal);
}

}  // namespace markservo::camera_check
