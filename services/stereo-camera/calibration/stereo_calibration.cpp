#include "services/stereo-camera/calibration/stereo_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <sstream>

#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/calibration/calibration_file.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kRectifiedTolerance_px = 1e-3;  // P1 and P2 share focal length and row to rounding
constexpr double kBaselineTolerance = 0.01;      // |T| against P2, relative

std::string number_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

CameraCalibration load_intrinsics(const CalibrationFile& file, const std::string& side) {
  CameraCalibration camera;
  camera.K = file.camera_matrix(file.first_of({"K" + side, "M" + side}));
  camera.D = file.distortion("D" + side);
  return camera;
}

void compute_rectification(const CalibrationFile& file, StereoCalibration& calibration) {
  if (!calibration.image_size) file.missing("image_width", "image_width and image_height, px, or R1, R2, P1 and P2");
  cv::Mat R1;
  cv::Mat R2;
  cv::Mat P1;
  cv::Mat P2;
  cv::Mat Q;
  cv::stereoRectify(calibration.left.K, calibration.left.D, calibration.right.K, calibration.right.D,
                    *calibration.image_size, file.rotation("R"), file.matrix("T", 3, 1), R1, R2, P1, P2, Q,
                    cv::CALIB_ZERO_DISPARITY, 0.0);
  for (const cv::Mat& matrix : {R1, R2, P1, P2}) {
    if (!cv::checkRange(matrix)) file.fail("T", "no usable baseline", "the right camera's place beside the left one");
  }
  calibration.left.R = R1;
  calibration.right.R = R2;
  calibration.left.P = P1;
  calibration.right.P = P2;
}

void load_rectification(const CalibrationFile& file, StereoCalibration& calibration) {
  const std::array<const char*, 4> keys{"R1", "R2", "P1", "P2"};
  const bool none = std::none_of(keys.begin(), keys.end(), [&](const char* key) { return file.has(key); });
  if (none && file.has("R") && file.has("T")) {
    compute_rectification(file, calibration);
    return;
  }
  calibration.left.R = file.rotation("R1");
  calibration.right.R = file.rotation("R2");
  calibration.left.P = file.projection("P1");
  calibration.right.P = file.projection("P2");
}

void check_rectified(const CalibrationFile& file, const StereoCalibration& calibration,
                     const CalibrationLimits& limits) {
  const cv::Matx34d& P1 = calibration.left.P;
  const cv::Matx34d& P2 = calibration.right.P;
  const auto differ = [](double a, double b) { return std::abs(a - b) > kRectifiedTolerance_px; };
  if (differ(P1(0, 0), P2(0, 0)) || differ(P1(1, 1), P2(1, 1)) || differ(P1(1, 2), P2(1, 2))) {
    file.fail("P2", "for another focal length or row than P1", "the P1 and P2 of one cv::stereoRectify");
  }
  if (P1(0, 3) != 0.0 || P1(1, 3) != 0.0) file.fail("P1", "not at the left camera", "a fourth column of 0");
  if (std::abs(P2(1, 3)) > std::abs(P2(0, 3))) {
    file.fail("P2", "for cameras above one another", "cameras side by side");
  }
  const double baseline = rectified_camera(calibration, limits.metres_per_unit).baseline;
  if (!(baseline > 0.0)) {
    file.fail("P2", "for a baseline of " + number_text(baseline) + " m",
              "above 0 (below 0: left and right camera are exchanged)");
  }
  if (baseline > limits.max_baseline) {
    file.fail(
        "P2", "for a baseline of " + number_text(baseline) + " m",
        "up to " + number_text(limits.max_baseline) + " m (for a board measured in mm pass --metres-per-unit 0.001)");
  }
  if (file.has("T")) {
    const double length = cv::norm(file.matrix("T", 3, 1)) * limits.metres_per_unit;
    if (std::abs(length - baseline) > kBaselineTolerance * baseline) {
      file.fail("T", number_text(length) + " m long, but P2 has a baseline of " + number_text(baseline) + " m",
                "T and P2 of one calibration");
    }
  }
}

void check_error(const CalibrationFile& file, const std::string& key, double error_px,
                 const CalibrationLimits& limits) {
  if (error_px < 0.0) file.fail(key, number_text(error_px) + " px", "0 or more");
  if (error_px <= limits.max_error_px || limits.accept_any_error) return;
  file.fail(key, number_text(error_px) + " px",
            "up to " + number_text(limits.max_error_px) + " px (calibrate again, or pass --accept-rms)");
}

}  // namespace

StereoCalibration load_stereo_calibration(const std::string& path, const CalibrationLimits& limits) {
  const CalibrationFile file(path);
  StereoCalibration calibration;
  calibration.left = load_intrinsics(file, "1");
  calibration.right = load_intrinsics(file, "2");
  calibration.image_size = file.image_size();
  if (!calibration.image_size) file.missing("image_width", "image_width and image_height, px (or image_size)");
  load_rectification(file, calibration);
  check_rectified(file, calibration, limits);
  calibration.rms = file.number("rms");
  if (!calibration.rms && !limits.accept_any_error) {
    file.missing("rms", "the calibration's reprojection error in px (or pass --accept-rms)");
  }
  if (calibration.rms) check_error(file, "rms", *calibration.rms, limits);
  const std::string epipolar = file.first_of({"epipolar_error", "epipolar_rms", "epipolar"});
  calibration.epipolar_error = file.number(epipolar);
  if (calibration.epipolar_error) check_error(file, epipolar, *calibration.epipolar_error, limits);
  return calibration;
}

StereoCalibration load_stereo_calibration(const std::string& intrinsics_path, const std::string& extrinsics_path,
                                          const CalibrationLimits& limits) {
  const CalibrationFile intrinsics(intrinsics_path);
  StereoCalibration calibration;
  calibration.left = load_intrinsics(intrinsics, "1");
  calibration.right = load_intrinsics(intrinsics, "2");
  calibration.image_size = intrinsics.image_size();
  const CalibrationFile extrinsics(extrinsics_path);
  load_rectification(extrinsics, calibration);
  check_rectified(extrinsics, calibration, limits);
  return calibration;
}

geometry::StereoCamera rectified_camera(const StereoCalibration& calibration, double metres_per_unit) {
  const cv::Matx34d& P1 = calibration.left.P;
  const cv::Matx34d& P2 = calibration.right.P;
  geometry::StereoCamera camera;
  camera.fx = P1(0, 0);
  camera.fy = P1(1, 1);
  camera.cx_left = P1(0, 2);
  camera.cx_right = P2(0, 2);
  camera.cy = P1(1, 2);
  camera.baseline = -P2(0, 3) / P2(0, 0) * metres_per_unit;
  return camera;
}

}  // namespace markservo::stereo_camera
