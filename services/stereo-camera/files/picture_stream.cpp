#include "services/stereo-camera/files/picture_stream.hpp"

#include <opencv2/imgcodecs.hpp>

#include "services/stereo-camera/files/schedule.hpp"

namespace markservo::stereo_camera {

StreamResult PictureStream::next() {
  StreamResult result;
  if (position_ >= pictures_.size()) return result;
  const PlacedPicture& picture = pictures_[position_++];
  result.time_us = time_of(0, picture.place, rate_hz_);
  try {
    result.image = cv::imread(picture.path, cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    result.image.release();  // larger than OpenCV's limit, or a decoder that gave up
  }
  result.status = result.image.empty() ? StreamStatus::kUnreadable : StreamStatus::kImage;
  if (result.image.empty()) result.reason = picture.path + ": not a readable picture";
  return result;
}

}  // namespace markservo::stereo_camera
