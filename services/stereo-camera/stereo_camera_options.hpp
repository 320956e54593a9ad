#pragma once

#include <cstdint>
#include <string>

#include "services/stereo-camera/calibration/camera_geometry.hpp"
#include "services/stereo-camera/source_options.hpp"

namespace CLI {
class App;
}

namespace markservo::stereo_camera {

struct StereoCameraOptions {
  SourceOptions source;
  GeometryOptions geometry;
  std::string encoding = "auto";  // raw, jpeg, or auto: raw where the network's buffers hold it
  int jpeg_quality = 90;          // colours and gradients stay within the camera's noise, at an eighth of the raw size
  std::int64_t count = 0;         // pairs to publish; 0: no limit
  bool once = false;              // one pair
};

void add_stereo_camera_options(CLI::App& app, StereoCameraOptions& options);

}  // namespace markservo::stereo_camera
