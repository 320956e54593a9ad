#include "services/stereo-camera/encoder.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>

namespace markservo::stereo_camera {
namespace {

constexpr int kMaxQuality = 100;

void require_colour(const cv::Mat& bgr) {
  if (bgr.empty() || bgr.type() != CV_8UC3) throw std::invalid_argument("encode: not an 8-bit colour picture");
}

}  // namespace

void encode_raw(const cv::Mat& bgr, std::vector<std::uint8_t>& bytes) {
  require_colour(bgr);
  const std::size_t row_bytes = static_cast<std::size_t>(bgr.cols) * bgr.elemSize();
  bytes.resize(row_bytes * static_cast<std::size_t>(bgr.rows));
  auto destination = bytes.begin();
  for (int row = 0; row < bgr.rows; ++row) {
    const std::uint8_t* source = bgr.ptr<std::uint8_t>(row);
    destination = std::copy(source, source + row_bytes, destination);
  }
}

void encode_jpeg(const cv::Mat& bgr, int quality, std::vector<std::uint8_t>& bytes) {
  require_colour(bgr);
  if (quality < 1 || quality > kMaxQuality) {
    throw std::invalid_argument("encode_jpeg: quality is " + std::to_string(quality) + "; allowed: 1 to 100");
  }
  if (!cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, quality})) {
    throw std::runtime_error("encode_jpeg: OpenCV could not encode the picture");
  }
}

}  // namespace markservo::stereo_camera
