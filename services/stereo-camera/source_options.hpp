#pragma once

// The settings that say where pairs come from, and the source they lead to.

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "services/stereo-camera/devices/v4l2_device.hpp"
#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {

struct SourceOptions {
  std::string left_device;  // two cameras
  std::string right_device;
  std::string device;  // one camera, side by side
  std::string left;    // two videos, picture patterns or pictures
  std::string right;
  std::string input;  // one of them, side by side
  bool side_by_side = false;
  bool loop = false;
  std::optional<double>
      rate_hz;  // absent: what the video states, else kDefaultFileRate_hz; of cameras kDefaultDeviceRate_hz
  bool wait_for_device = false;
  int width = 0;        // px of one view, asked of cameras; 0: as calibrated
  int height = 0;       // px
  V4l2Settings camera;  // exposure and white balance; path, size and rate are filled in here
};

inline constexpr double kDefaultFileRate_hz = 10.0;
inline constexpr double kDefaultDeviceRate_hz = 30.0;

struct OpenedSource {
  std::unique_ptr<FrameSource> source;
  bool live = false;     // cameras: they pace themselves and know when a frame was taken
  double rate_hz = 0.0;  // of files
  std::string note;      // pictures that are left out; empty when none is
};

// Checks that exactly one way is chosen and opens it. `view_size` is what one camera view should have where the options
// do not say. Throws ConfigurationError that names the option, its value and what is allowed.
OpenedSource open_source(const SourceOptions& options, cv::Size view_size);

}  // namespace markservo::stereo_camera
