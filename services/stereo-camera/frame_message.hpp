#pragma once

#include <cstdint>
#include <markservo/StereoFrame.hpp>
#include <opencv2/core.hpp>
#include <optional>

#include "services/stereo-camera/calibration/camera_geometry.hpp"
#include "services/stereo-camera/calibration/chosen_cameras.hpp"
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
  const ChosenCameras& cameras() const { return cameras_; }      // since begin()

  // Of a pair of that size, until the next one; session and seq are the publisher's.
  StereoFrame& of(const RawPair& pair, std::int64_t utime);

 private:
  std::optional<cv::Size> size_;
  ChosenCameras cameras_;
  std::optional<int> jpeg_quality_;  // nothing: raw
  StereoFrame message_{};
};

}  // namespace markservo::stereo_camera
