#include "services/mark-detector/picture/picture_file.hpp"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "common/robot/configuration_error.hpp"

namespace markservo::mark_detector {

namespace {

// The picture in `bytes`, 8-bit BGR; an empty image if they are none.
cv::Mat decode_picture(const std::vector<std::uint8_t>& bytes) {
  try {
    return bytes.empty() ? cv::Mat() : cv::imdecode(bytes, cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace

cv::Mat read_picture(const std::string& option, const std::string& path) {
  // Not cv::imread, which writes warnings of its own.
  std::ifstream file(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  cv::Mat image = decode_picture(bytes);
  if (image.empty()) throw ConfigurationError(option + " '" + path + "': cannot be read; allowed: a picture file");
  return image;
}

void write_picture(const std::string& option, const std::string& path, const cv::Mat& image) {
  bool written = false;
  try {
    written = cv::imwrite(path, image);
  } catch (const cv::Exception&) {
    written = false;
  }
  if (!written) throw ConfigurationError(option + " '" + path + "': cannot be written; allowed: a picture file");
}

}  // namespace markservo::mark_detector
