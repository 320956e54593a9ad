#include "services/stereo-camera/files/picture_stream.hpp"

#include <opencv2/imgcodecs.hpp>

namespace markservo::stereo_camera {

StreamResult PictureStream::next() {
  StreamResult result;
  if (position_ >= paths_.size()) return result;
  const std::string& path = paths_[position_++];
  try {
    result.image = cv::imread(path, cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    result.image.release();  // larger than OpenCV's limit, or a decoder that gave up
  }
  result.status = result.image.empty() ? StreamStatus::kUnreadable : StreamStatus::kImage;
  if (result.image.empty()) result.reason = path + ": not a readable picture";
  return result;
}

}  // namespace markservo::stereo_camera
