#pragma once

// A stereo calibration as cv::stereoCalibrate and cv::stereoRectify give it, read from OpenCV's files.

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "common/geometry/stereo_camera.hpp"

namespace markservo::stereo_camera {

// One camera: how its raw image is undistorted, turned and projected into the rectified one.
struct CameraCalibration {
  cv::Matx33d K;  // px, camera matrix of the raw image
  cv::Mat D;      // 1 x n, OpenCV's distortion coefficients
  cv::Matx33d R;  // raw camera frame to rectified camera frame
  cv::Matx34d P;  // px, projection of the rectified frame of the left camera
};

struct StereoCalibration {
  std::optional<cv::Size> image_size;  // px; OpenCV's samples do not write it
  CameraCalibration left;
  CameraCalibration right;
  std::optional<double> rms;             // px, reprojection error of the calibration
  std::optional<double> epipolar_error;  // px, mean distance of points from their epipolar lines
};

struct CalibrationLimits {
  double max_error_px = 0.5;      // above, rows of the two images do not agree well enough to match on one row
  bool accept_any_error = false;  // take a calibration whose errors are larger or not stated
  double metres_per_unit = 1.0;   // of the calibration's translation: the unit in which the board's squares were given
  double max_baseline = 2.0;      // m, above it the unit is wrong
};

// Reads one file with K1 D1 K2 D2, R1 R2 P1 P2 (or R T, from which they are computed with ZERO_DISPARITY and alpha 0),
// image_width and image_height (or image_size), rms, and where present epipolar_error.
// Throws ConfigurationError: one line with file, key, value and what is allowed.
StereoCalibration load_stereo_calibration(const std::string& path, const CalibrationLimits& limits);

// Reads the pair of files that OpenCV's stereo_calib sample writes: M1 D1 M2 D2 and R1 R2 P1 P2. They state neither
// size nor rms: the size is that of the images, and the error is taken on trust.
StereoCalibration load_stereo_calibration(const std::string& intrinsics_path, const std::string& extrinsics_path,
                                          const CalibrationLimits& limits);

// The rectified pair that the calibration leads to; baseline in m.
geometry::StereoCamera rectified_camera(const StereoCalibration& calibration, double metres_per_unit);

}  // namespace markservo::stereo_camera
