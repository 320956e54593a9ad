#include "services/simulator/cameras/camera_mjcf.hpp"

#include <cmath>

#include "common/geometry/degrees.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/simulator/model/mjcf_writer.hpp"

namespace markservo::simulator {

void require_drawable(const robot::CameraDescription& cameras) {
  const auto& stereo = cameras.stereo;
  const double middle_u = 0.5 * (cameras.width - 1);
  const double middle_v = 0.5 * (cameras.height - 1);
  if (stereo.fx != stereo.fy) {
    throw ConfigurationError("cameras.fy_px is " + mjcf(stereo.fy) + "; allowed in the simulator: cameras.fx_px, " +
                             mjcf(stereo.fx));
  }
  if (stereo.cx_left != middle_u || stereo.cx_right != middle_u || stereo.cy != middle_v) {
    throw ConfigurationError("cameras.cx_left_px, cx_right_px, cy_px are " + mjcf(stereo.cx_left) + ", " +
                             mjcf(stereo.cx_right) + ", " + mjcf(stereo.cy) +
                             "; allowed in the simulator: the image's middle, " + mjcf(middle_u) + ", " +
                             mjcf(middle_u) + ", " + mjcf(middle_v));
  }
}

double vertical_view_deg(const robot::CameraDescription& cameras) {
  return 2.0 * std::atan(0.5 * cameras.height / cameras.stereo.fy) / geometry::kRadiansPerDegree;
}

std::string camera_pair(const robot::CameraDescription& cameras) {
  const std::string view = mjcf(vertical_view_deg(cameras));
  const auto camera = [&](const char* name, double x) {
    return "<camera " + named(name) + " " + at({x, 0.0, 0.0}) + " xyaxes=\"1 0 0 0 0 1\" fovy=\"" + view + "\"/>\n";
  };
  return camera(kLeftCamera, 0.0) + camera(kRightCamera, cameras.stereo.baseline);
}

}  // namespace markservo::simulator
