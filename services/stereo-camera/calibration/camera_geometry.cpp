#include "services/stereo-camera/calibration/camera_geometry.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "common/robot/configuration_error.hpp"
#include "common/robot/robot_description.hpp"

namespace markservo::stereo_camera {
namespace {

void require_positive(const std::optional<double>& value, const std::string& option, const std::string& unit) {
  if (value && !(*value > 0.0 && std::isfinite(*value))) {
    throw ConfigurationError(option + " is " + std::to_string(*value) + " " + unit + "; allowed: above 0");
  }
}

void require_finite(const std::optional<double>& value, const std::string& option) {
  if (value && !std::isfinite(*value)) throw ConfigurationError(option + " is not finite; allowed: a number of px");
}

bool any_override(const GeometryOptions& options) {
  const std::array<bool, 6> given{options.fx.has_value(),       options.fy.has_value(), options.cx_left.has_value(),
                                  options.cx_right.has_value(), options.cy.has_value(), options.baseline.has_value()};
  for (const bool one : given) {
    if (one) return true;
  }
  return false;
}

void check_overrides(const GeometryOptions& options) {
  if (!options.fx || !options.baseline) {
    throw ConfigurationError(std::string(options.fx ? "--baseline" : "--fx") +
                             " is missing; allowed: --fx and --baseline together when one of --fx, --fy, --cx-left, "
                             "--cx-right, --cy, --baseline is given");
  }
  require_positive(options.fx, "--fx", "px");
  require_positive(options.fy, "--fy", "px");
  require_positive(options.baseline, "--baseline", "m");
  require_finite(options.cx_left, "--cx-left");
  require_finite(options.cx_right, "--cx-right");
  require_finite(options.cy, "--cy");
}

}  // namespace

geometry::StereoCamera CameraGeometry::camera(cv::Size picture_size) const {
  if (calibration) return rectified_camera(*calibration, options.limits.metres_per_unit);
  if (!overridden) return from_robot;
  // Pixel centres are at integers, so the middle of n px is (n - 1) / 2.
  const double middle_u = 0.5 * (picture_size.width - 1);
  const double middle_v = 0.5 * (picture_size.height - 1);
  geometry::StereoCamera camera;
  camera.fx = *options.fx;
  camera.fy = options.fy.value_or(*options.fx);
  camera.cx_left = options.cx_left.value_or(middle_u);
  camera.cx_right = options.cx_right.value_or(middle_u);
  camera.cy = options.cy.value_or(middle_v);
  camera.baseline = *options.baseline;
  return camera;
}

CameraGeometry choose_geometry(const GeometryOptions& options, const std::string& robot_file) {
  const bool sample_files = !options.intrinsics.empty() || !options.extrinsics.empty();
  const bool overridden = any_override(options);
  if ((options.calibration.empty() ? 0 : 1) + (sample_files ? 1 : 0) + (overridden ? 1 : 0) > 1) {
    throw ConfigurationError(
        "cameras are described twice; allowed: one of --calibration, --intrinsics with --extrinsics, or --fx and its "
        "companions");
  }
  require_positive(options.limits.metres_per_unit, "--metres-per-unit", "m");
  CameraGeometry geometry;
  geometry.options = options;
  geometry.overridden = overridden;
  if (sample_files) {
    if (options.intrinsics.empty() || options.extrinsics.empty()) {
      throw ConfigurationError("only one of --intrinsics and --extrinsics is given; allowed: both");
    }
    geometry.calibration = load_stereo_calibration(options.intrinsics, options.extrinsics, options.limits);
    geometry.size_source = options.intrinsics;
  } else if (!options.calibration.empty()) {
    geometry.calibration = load_stereo_calibration(options.calibration, options.limits);
    geometry.size_source = options.calibration;
  } else if (overridden) {
    check_overrides(options);
  } else {
    const robot::RobotDescription robot = robot::load_robot_description(robot_file);
    geometry.size = cv::Size(robot.cameras.width, robot.cameras.height);
    geometry.size_source = robot_file;
    geometry.from_robot = robot.cameras.stereo;
  }
  if (geometry.calibration) geometry.size = geometry.calibration->image_size;
  return geometry;
}

}  // namespace markservo::stereo_camera
