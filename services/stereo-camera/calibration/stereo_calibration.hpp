#pragma once

// A stereo calibration, read from the files that calibration tools write.

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "services/stereo-camera/calibration/lens.hpp"

namespace markservo::stereo_camera {

// One camera: how its raw image is undistorted, turned and projected into the rectified one.
struct CameraCalibration {
  cv::Matx33d K;  // px, camera matrix of the raw image
  cv::Mat D;      // 1 x n, OpenCV's distortion coefficients for the lens
  cv::Matx33d R;  // raw camera frame to rectified camera frame
  cv::Matx34d P;  // px and m, projection of the rectified frame of the left camera
};

// Where the right camera is: p_right = R p_left + T.
struct RelativePose {
  cv::Matx33d R;
  cv::Vec3d T;  // m
};

struct StereoCalibration {
  std::string path;                    // for messages: the file that has R, T and P2
  std::optional<cv::Size> image_size;  // px; where no file states it the pictures' own
  Lens lens = Lens::kPinhole;
  CameraCalibration left;
  CameraCalibration right;
  std::optional<RelativePose> relative;  // where stated
  bool rectified = false;                // whether R and P of both are set; `relative` is otherwise
  std::vector<std::string> warnings;     // what was taken on trust
};

struct CalibrationOptions {
  double max_error_px = 0.5;      // above, rows of the two images do not agree well enough to match on one row
  bool accept_any_error = false;  // take a calibration whose errors are larger or not stated
  // m, of the unit of T, which is that in which the board's squares were given to the tool; absent: 1
  std::optional<double> metres_per_unit;
  // m, the edge of the board's squares, for a T that counts in squares (or in the file's own `square_size`)
  std::optional<double> board_square;
  std::optional<Lens> lens;  // absent: as the file says, else pinhole
};

// A T of more squares than this is in another unit: a board that both cameras see whole is further away than they are
// apart, and then its squares would be too small to be found.
inline constexpr double kMaxSquaresOfBaseline = 25.0;

// Reads `paths`: one file with K1 D1 K2 D2, R1 R2 P1 P2 and/or R T, image size and rms, as most users of OpenCV write
// it; the two of OpenCV's stereo_calib sample, which say M1 for K1 and state neither size nor rms; or the left and the
// right camera_info of ROS's camera_calibration. Throws ConfigurationError: one line with file, key, value and what is
// allowed.
StereoCalibration load_stereo_calibration(const std::vector<std::string>& paths, const CalibrationOptions& options);

// The rectified pair that a rectified calibration leads to.
geometry::StereoCamera rectified_camera(const StereoCalibration& calibration);

}  // namespace markservo::stereo_camera
