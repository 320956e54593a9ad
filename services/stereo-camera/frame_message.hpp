#pragma once

#include <cstdint>
#include <markservo/StereoFrame.hpp>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>

#include "services/stereo-camera/calibration/camera_geometry.hpp"
#include "services/stereo-camera/calibration/rectifier.hpp"
#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {

// The STEREO_FRAME that a pair becomes: rectified where there is a calibration, and encoded.
class FrameMessage {
 public:
  void encode_raw_pictures();
  void encode_jpeg_pictures(int quality);  // 1 to 100

  // Says which cameras take the pairs and of which size they all are. Throws ConfigurationError, and changes nothing,
  // where the pictures do not suit the geometry.
  void begin(const CameraGeometry& geometry, cv::Size size);
  const std::optional<cv::Size>& size() const { return size_; }  // px; nothing before begin()

  // Of a pair of that size, until the next one; session and seq are the publisher's.
  StereoFrame& of(const RawPair& pair, std::int64_t utime);

 private:
  std::optional<cv::Size> size_;
  std::unique_ptr<Rectifier> rectifier_;
  std::optional<int> jpeg_quality_;  // nothing: raw
  StereoFrame message_{};
};

}  // namespace markservo::stereo_camera
