#pragma once

// Which cameras the published pairs come from: a calibration file, settings of the command line, or robot.yaml.

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "common/geometry/stereo_camera.hpp"
#include "services/stereo-camera/calibration/stereo_calibration.hpp"

namespace markservo::stereo_camera {

struct GeometryOptions {
  std::string calibration;  // one file, or
  std::string intrinsics;   // the two files of OpenCV's stereo_calib sample
  std::string extrinsics;
  CalibrationLimits limits;
  // Rectified pictures of other people's cameras.
  std::optional<double> fx;        // px
  std::optional<double> fy;        // px; absent: fx
  std::optional<double> cx_left;   // px; absent: the picture's middle
  std::optional<double> cx_right;  // px; absent: the picture's middle
  std::optional<double> cy;        // px; absent: the picture's middle
  std::optional<double> baseline;  // m
};

struct CameraGeometry {
  std::optional<StereoCalibration> calibration;  // to rectify by; absent: pairs are published as they come
  std::optional<cv::Size> size;                  // px that the pictures must have; absent: any
  std::string size_source;                       // who says so, for messages
  GeometryOptions options;
  bool overridden = false;            // by options.fx and its companions
  geometry::StereoCamera from_robot;  // where neither calibration nor overrides are given

  // The rectified pair for pictures of `picture_size`.
  geometry::StereoCamera camera(cv::Size picture_size) const;
};

// Throws ConfigurationError. `robot_file` is read only where neither a calibration nor overrides are given.
CameraGeometry choose_geometry(const GeometryOptions& options, const std::string& robot_file);

}  // namespace markservo::stereo_camera
