#include "services/stereo-camera/calibration/stereo_calibration.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "common/geometry/camera_bounds.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/calibration/calibration_file.hpp"
#include "services/stereo-camera/calibration/camera_info.hpp"
#include "services/stereo-camera/calibration/opencv_calibration.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kRectifiedTolerance_px = 1e-3;  // P1 and P2 share focal length and row to rounding
constexpr double kBaselineTolerance = 0.01;      // |T| against P2, relative

constexpr const char* kUnits =
    "T is in the unit in which the board's squares were given: --metres-per-unit 0.001 for mm, 0.01 for cm, 0.0254 for "
    "inches; --board-square EDGE, in m, for squares";

void scale(StereoCalibration& calibration, double metres) {
  if (calibration.relative) calibration.relative->T *= metres;
  calibration.right.P(0, 3) *= metres;
  calibration.right.P(1, 3) *= metres;
}

void check_baseline(const CalibrationFile& file, const std::string& key, double baseline) {
  const geometry::Bounds bounds = geometry::kBaselineBounds;
  if (bounds.hold(baseline)) return;
  const std::string value = fmt::format("for a baseline of {:.6g} m", baseline);
  if (!(baseline > 0.0)) file.fail(key, value, "above 0 (below 0: left and right camera are exchanged)");
  file.fail(key, value, fmt::format("{:.6g} to {:.6g} m ({})", bounds.min, bounds.max, kUnits));
}

// What `file`, the extrinsics' or the right camera's, says of both projections. `first` is the intrinsics' or the left
// camera's.
void check_projections(const CalibrationFile& first, const CalibrationFile& file,
                       const StereoCalibration& calibration) {
  const std::string key = file.has({"P2"}) ? "P2" : projection_name(file);
  const cv::Matx34d& P1 = calibration.left.P;
  const cv::Matx34d& P2 = calibration.right.P;
  const auto differ = [](double a, double b) { return std::abs(a - b) > kRectifiedTolerance_px; };
  if (differ(P1(0, 0), P2(0, 0)) || differ(P1(1, 1), P2(1, 1)) || differ(P1(1, 2), P2(1, 2))) {
    file.fail(key, "for another focal length or row than the left camera's (P1)", "P1 and P2 of one cv::stereoRectify");
  }
  if (P1(0, 3) != 0.0 || P1(1, 3) != 0.0) {
    const bool both = file.has({"P1"});
    (both ? file : first).fail(both ? "P1" : projection_name(first), "not at the left camera", "a fourth column of 0");
  }
  if (std::abs(P2(1, 3)) > std::abs(P2(0, 3))) {
    file.fail(key, "for cameras above one another", "cameras side by side");
  }
  const double baseline = rectified_camera(calibration).baseline;
  check_baseline(file, key, baseline);
  if (!calibration.relative) return;
  const double length = cv::norm(calibration.relative->T);
  if (std::abs(length - baseline) > kBaselineTolerance * baseline) {
    file.fail("T", fmt::format("{:.6g} m long, but P2 has a baseline of {:.6g} m", length, baseline),
              "T and P2 of one calibration");
  }
}

void check_relative(const CalibrationFile& file, const StereoCalibration& calibration) {
  const cv::Vec3d& T = calibration.relative->T;
  if (std::abs(T[1]) > std::abs(T[0])) file.fail("T", "for cameras above one another", "cameras side by side");
  check_baseline(file, "T", T[0] < 0.0 ? cv::norm(T) : -cv::norm(T));
}

// Of a camera_info file.
void require_metres(const CalibrationFile& file, const CalibrationOptions& options) {
  for (const auto& [option, value] :
       {std::pair{"--board-square", options.board_square}, std::pair{"--metres-per-unit", options.metres_per_unit}}) {
    if (!value) continue;
    throw ConfigurationError(
        fmt::format("{}: is ROS's camera_info, whose lengths are in metres, and {} is {:.6g}; allowed: without that "
                    "option (of a board whose squares were given wrong: calibrate again)",
                    file.path(), option, *value));
  }
}

StereoCalibration finished(const CalibrationFile& first, const CalibrationFile& file, StereoCalibration calibration) {
  if (calibration.rectified) {
    check_projections(first, file, calibration);
  } else {
    check_relative(file, calibration);
  }
  if (!calibration.image_size) {
    calibration.warnings.push_back(file.path() + ": states no image size; the pictures' own is taken for it");
  }
  return calibration;
}

}  // namespace

StereoCalibration load_stereo_calibration(const std::vector<std::string>& paths, const CalibrationOptions& options) {
  if (paths.empty() || paths.size() > 2) {
    throw ConfigurationError(fmt::format(
        "--calibration names {} files; allowed: one of both cameras, or the left and the right one's", paths.size()));
  }
  const CalibrationFile first(paths.front());
  if (paths.size() == 1) {
    if (is_camera_info(first)) {
      throw ConfigurationError(first.path() +
                               ": describes one camera; allowed: two of these, --calibration LEFT RIGHT, or one file "
                               "with K1, D1, K2, D2, R and T");
    }
    StereoCalibration calibration = read_opencv_calibration(first, first, options);
    scale(calibration, metres_per_unit(first, calibration, options));
    return finished(first, first, std::move(calibration));
  }
  const CalibrationFile second(paths.back());
  if (is_camera_info(first) || is_camera_info(second)) {
    require_metres(second, options);
    return finished(first, second, read_camera_info(first, second, options));
  }
  StereoCalibration calibration = read_opencv_calibration(first, second, options);
  scale(calibration, metres_per_unit(second, calibration, options));
  return finished(first, second, std::move(calibration));
}

geometry::StereoCamera rectified_camera(const StereoCalibration& calibration) {
  const cv::Matx34d& P1 = calibration.left.P;
  const cv::Matx34d& P2 = calibration.right.P;
  geometry::StereoCamera camera;
  camera.fx = P1(0, 0);
  camera.fy = P1(1, 1);
  camera.cx_left = P1(0, 2);
  camera.cx_right = P2(0, 2);
  camera.cy = P1(1, 2);
  camera.baseline = -P2(0, 3) / P2(0, 0);
  return camera;
}

}  // namespace markservo::stereo_camera
