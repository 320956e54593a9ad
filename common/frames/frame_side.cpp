#include "common/frames/frame_side.hpp"

#include <fmt/core.h>

#include <optional>
#include <stdexcept>

#include "common/frames/jpeg_size.hpp"

namespace markservo::frames {

cv::Mat picture_of(const StereoFrame& frame, const std::vector<std::uint8_t>& side, const std::string& name,
                   JpegDecoder& decoder) {
  if (frame.encoding == StereoFrame::ENCODING_BGR8) {
    return {frame.height, frame.width, CV_8UC3, const_cast<std::uint8_t*>(side.data())};
  }
  // Before any pixel is decoded: a small message can claim an image of gigabytes.
  const std::optional<JpegSize> size = jpeg_size(side);
  if (size && (size->width != frame.width || size->height != frame.height)) {
    throw std::runtime_error(fmt::format("{}'s JPEG is {} x {} px; allowed: the frame's {} x {} px", name, size->width,
                                         size->height, frame.width, frame.height));
  }
  cv::Mat picture = size ? decoder.unpack(side, {frame.width, frame.height}) : cv::Mat();
  if (picture.empty()) throw std::runtime_error(name + " is no JPEG that can be read");
  return picture;
}

}  // namespace markservo::frames
