#include "tests/scenes/seen_difference.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace markservo::scenes {
namespace {

constexpr double kWhite = 255.0;

double luma(const mark_detector::Bgr& colour) {
  return 0.114 * colour[0] + 0.587 * colour[1] + 0.299 * colour[2];
}

// L*, a*, b* in `gain` times the light.
cv::Vec3f lab(const mark_detector::Bgr& colour, double gain) {
  cv::Mat3f pixel(1, 1);
  for (int c = 0; c < 3; ++c) {
    pixel(0, 0)[c] = static_cast<float>(gain * colour.at(static_cast<std::size_t>(c)) / kWhite);
  }
  cv::cvtColor(pixel, pixel, cv::COLOR_BGR2Lab);
  return pixel(0, 0);
}

}  // namespace

double seen_difference(const mark_detector::Bgr& one, const mark_detector::Bgr& other) {
  const cv::Vec3f a = lab(one, 1.0);
  const cv::Vec3f b = lab(other, luma(one) / luma(other));
  const double chroma = std::hypot(a[1], a[2]);
  const double lightness_apart = a[0] - b[0];
  const double chroma_apart = chroma - std::hypot(b[1], b[2]);
  const double squared_apart = std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2);
  const double hue_apart = std::sqrt(std::max(0.0, squared_apart - chroma_apart * chroma_apart));
  return std::hypot(lightness_apart, chroma_apart / (1.0 + 0.045 * chroma), hue_apart / (1.0 + 0.015 * chroma));
}

}  // namespace markservo::scenes
