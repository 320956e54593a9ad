#pragma once

#include <memory>
#include <string>

#include "services/stereo-camera/devices/capture_device.hpp"
#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {

// Pairs from cameras: two, whose frames are paired by time, or one that delivers both views side by side. A lost camera
// is opened again at the next read() after kWaiting; the caller waits in between.
class DeviceSource : public FrameSource {
 public:
  // `rate_hz` is used where a driver states none.
  DeviceSource(DeviceOpener left, DeviceOpener right, double rate_hz);
  DeviceSource(DeviceOpener side_by_side, double rate_hz);

  ReadResult read() override;

 private:
  struct Camera {
    DeviceOpener open;
    std::unique_ptr<CaptureDevice> device;
    bool holds_frame = false;  // grabbed and not yet used
  };

  bool open(std::string& reason);
  void close();
  bool grab(std::string& reason);
  ReadResult read_two();
  ReadResult read_side_by_side();

  Camera left_;
  Camera right_;
  bool two_cameras_;
  double rate_hz_;
  std::int64_t next_index_ = 0;
};

}  // namespace markservo::stereo_camera
