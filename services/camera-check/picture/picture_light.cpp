#include "services/camera-check/picture/picture_light.hpp"

#include <array>
#include <cstdint>

namespace markservo::camera_check {
namespace {

constexpr int kLevels = 256;
constexpr int kBlownLevel = 250;
constexpr double kBrightShare = 0.95;

using Histogram = std::array<std::int64_t, kLevels>;

// The least level that `share` of the pixels do not exceed.
double level_below(const Histogram& histogram, double share, std::int64_t pixels) {
  const double wanted = share * static_cast<double>(pixels);
  std::int64_t count = 0;
  for (int level = 0; level < kLevels; ++level) {
    count += histogram[static_cast<std::size_t>(level)];
    if (static_cast<double>(count) >= wanted) return level;
  }
  return kLevels - 1;
}

}  // namespace

PictureLight light_of(const cv::Mat& grey) {
  Histogram histogram{};
  for (int v = 0; v < grey.rows; ++v) {
    const auto* row = grey.ptr<std::uint8_t>(v);
    for (int u = 0; u < grey.cols; ++u) ++histogram[row[u]];
  }
  const auto pixels = static_cast<std::int64_t>(grey.total());
  std::int64_t blown = 0;
  for (int level = kBlownLevel; level < kLevels; ++level) blown += histogram[static_cast<std::size_t>(level)];
  PictureLight light;
  light.bright_level = level_below(histogram, kBrightShare, pixels);
  light.middle_level = level_below(histogram, 0.5, pixels);
  light.blown_share = pixels == 0 ? 0.0 : static_cast<double>(blown) / static_cast<double>(pixels);
  return light;
}

}  // namespace markservo::camera_check
