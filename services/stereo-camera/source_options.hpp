#pragma once

// The settings that say where pairs come from, and the source they lead to.

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

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
  // Of files: what pictures are played by, and videos in place of their own times. Absent: kDefaultFileRate_hz, and
  // videos by their times. Of cameras: what is asked of them; absent: kDefaultDeviceRate_hz.
  std::optional<double> rate_hz;
  std::optional<double> offset_s;  // of two videos: right video's time minus left's at the same moment; absent: 0
  bool estimate_offset = false;    // by what moves in both
  bool wait_for_device = false;
  int width = 0;        // px of one view, asked of cameras; 0: as calibrated
  int height = 0;       // px
  V4l2Settings camera;  // exposure and white balance; path, size and rate are filled in here
};

inline constexpr double kDefaultFileRate_hz = 10.0;
inline constexpr double kDefaultDeviceRate_hz = 30.0;

struct OpenedSource {
  std::unique_ptr<FrameSource> source;
  bool live = false;                  // cameras: they pace themselves and know when a frame was taken
  std::int64_t period_us = 0;         // of files: between two pictures, where none is missing
  std::vector<std::string> warnings;  // pictures that are left out, rates that differ
  std::string note;                   // the offset that was found; empty when none was looked for
};

// Checks that exactly one way is chosen and opens it. `view_size` is what one camera view should have where the options
// do not say. Throws ConfigurationError that names the option, its value and what is allowed.
OpenedSource open_source(const SourceOptions& options, cv::Size view_size);

}  // namespace markservo::stereo_camera
