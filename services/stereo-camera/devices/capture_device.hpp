#pragma once

// One opened camera, so that pairing and recovery can be tested without hardware.

#include <cstdint>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <string>

namespace markservo::stereo_camera {

class CaptureDevice {
 public:
  virtual ~CaptureDevice() = default;

  // Waits for the next frame, at most about a second; false where none came: the device is lost.
  virtual bool grab() = 0;

  // When the grabbed frame was taken, us since the epoch.
  virtual std::int64_t utime() = 0;

  // Decodes the grabbed frame; an empty image where it is damaged.
  virtual cv::Mat retrieve() = 0;

  // As the driver states it, frames per second; 0 where it does not.
  virtual double rate() const = 0;
};

// Opens a camera; null, and why in `reason`, where it is not there.
using DeviceOpener = std::function<std::unique_ptr<CaptureDevice>(std::string& reason)>;

}  // namespace markservo::stereo_camera
