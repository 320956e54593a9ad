#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "services/stereo-camera/devices/capture_device.hpp"

namespace markservo::stereo_camera {

struct V4l2Settings {
  std::string path;                       // for example /dev/video0
  cv::Size size;                          // px, asked for
  double rate_hz = 30.0;                  // asked for
  std::optional<double> exposure;         // in the driver's unit (UVC: 100 us); automatic where absent
  std::optional<double> white_balance_K;  // fixed at this; where absent it is held as it is
  bool auto_white_balance = false;        // a drifting balance moves the marks' colours and differs from side to side
};

// Opens a V4L2 camera: MJPG, one buffer so that frames are fresh, focus fixed. What the driver does not take is logged.
// Null, with a one-line reason that names the path and the fix, where it cannot be used.
std::unique_ptr<CaptureDevice> open_v4l2(const V4l2Settings& settings, std::string& reason);

}  // namespace markservo::stereo_camera
