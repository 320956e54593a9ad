#include "services/log-tool/frame_pictures.hpp"

#include <optional>
#include <vector>

#include "common/frames/jpeg_decoder.hpp"
#include "common/frames/jpeg_size.hpp"

namespace markservo::log_tool {
namespace {

// StereoFrame.lcm's constants.
constexpr std::int64_t kBgr8 = 0;
constexpr std::int64_t kJpeg = 1;
constexpr std::int64_t kMostPixels = 16384;  // a side; more is no camera's

cv::Mat picture(const reflection::Fields& frame, const char* side) {
  const auto* value = frame.find(side);
  const auto* bytes = value == nullptr ? nullptr : std::get_if<reflection::Bytes>(&value->content);
  const auto width = reflection::integer_in(frame, "width", 0);
  const auto height = reflection::integer_in(frame, "height", 0);
  const auto encoding = reflection::integer_in(frame, "encoding", -1);
  if (bytes == nullptr || bytes->size == 0) return {};
  if (encoding == kJpeg) {
    const std::vector<std::uint8_t> file(bytes->data, bytes->data + bytes->size);
    const std::optional<frames::JpegSize> size = frames::jpeg_size(file);
    if (!size || size->width > kMostPixels || size->height > kMostPixels) return {};
    return frames::JpegDecoder().unpack(file, {size->width, size->height});
  }
  if (encoding != kBgr8 || width < 1 || height < 1 || width > kMostPixels || height > kMostPixels) return {};
  if (bytes->size != static_cast<std::size_t>(3 * width * height)) return {};
  // OpenCV's matrices take no const data; this one is only read.
  auto* data = const_cast<std::uint8_t*>(bytes->data);
  return cv::Mat(static_cast<int>(height), static_cast<int>(width), CV_8UC3, data);
}

}  // namespace

FramePictures pictures_of(const reflection::Fields& frame) {
  FramePictures pictures{"", picture(frame, "left"), picture(frame, "right")};
  if (pictures.left.empty() || pictures.right.empty()) {
    pictures.error = "images of " + std::to_string(reflection::integer_in(frame, "left_size", 0)) + " and " +
                     std::to_string(reflection::integer_in(frame, "right_size", 0)) +
                     " bytes are neither BGR8 of the frame's size nor JPEG";
  }
  return pictures;
}

}  // namespace markservo::log_tool
