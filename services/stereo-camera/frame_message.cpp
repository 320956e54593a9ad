#include "services/stereo-camera/frame_message.hpp"

#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/encoder.hpp"

namespace markservo::stereo_camera {

void FrameMessage::encode_raw_pictures() {
  jpeg_quality_.reset();
  message_.encoding = StereoFrame::ENCODING_BGR8;
}

void FrameMessage::encode_jpeg_pictures(int quality) {
  jpeg_quality_ = quality;
  message_.encoding = StereoFrame::ENCODING_JPEG;
}

void FrameMessage::begin(const CameraGeometry& geometry, cv::Size size) {
  if (geometry.size && size != *geometry.size) {
    throw ConfigurationError("pictures are " + size_text(size) + "; allowed: " + size_text(*geometry.size) + " as in " +
                             geometry.size_source +
                             (geometry.calibration ? "" : " (or --calibration, or --fx and --baseline)"));
  }
  if (geometry.calibration) rectifier_ = std::make_unique<Rectifier>(*geometry.calibration, size);
  const geometry::StereoCamera camera = geometry.camera(size);
  message_.calibration.fx = camera.fx;
  message_.calibration.fy = camera.fy;
  message_.calibration.cx_left = camera.cx_left;
  message_.calibration.cx_right = camera.cx_right;
  message_.calibration.cy = camera.cy;
  message_.calibration.baseline = camera.baseline;
  message_.width = size.width;
  message_.height = size.height;
  size_ = size;
}

StereoFrame& FrameMessage::of(const RawPair& pair, std::int64_t utime) {
  cv::Mat left = pair.left;
  cv::Mat right = pair.right;
  if (rectifier_) {
    cv::Mat left_rectified;
    cv::Mat right_rectified;
    rectifier_->rectify(left, right, left_rectified, right_rectified);
    left = left_rectified;
    right = right_rectified;
  }
  if (jpeg_quality_) {
    encode_jpeg(left, *jpeg_quality_, message_.left);
    encode_jpeg(right, *jpeg_quality_, message_.right);
  } else {
    encode_raw(left, message_.left);
    encode_raw(right, message_.right);
  }
  message_.left_size = static_cast<std::int32_t>(message_.left.size());
  message_.right_size = static_cast<std::int32_t>(message_.right.size());
  message_.utime = utime;
  return message_;
}

}  // namespace markservo::stereo_camera
