#include "services/stereo-camera/calibration/camera_info.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "common/text/text.hpp"

namespace markservo::stereo_camera {
namespace {

using Keys = CalibrationFile::Keys;

const Keys kCameraMatrix{"camera_matrix", "K", "k"};
const Keys kDistortion{"distortion_coefficients", "D", "d"};
const Keys kRotation{"rectification_matrix", "R", "r"};
const Keys kProjection{"projection_matrix", "P", "p"};
const Keys kModel{"distortion_model"};

Lens lens_of(const CalibrationFile& file, const CalibrationOptions& options) {
  const std::vector<std::string> pinhole{"plumb_bob", "rational_polynomial", "thin_prism", "none", ""};
  const std::vector<std::string> fisheye{"equidistant", "fisheye"};
  const auto one_of = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const std::optional<std::string> model = file.text(kModel);
  if (!model) return options.lens.value_or(Lens::kPinhole);
  if (!one_of(pinhole, *model) && !one_of(fisheye, *model)) {
    file.fail(kModel.front(), "'" + text::printable(*model) + "'",
              "plumb_bob, rational_polynomial, thin_prism or equidistant");
  }
  const Lens stated = one_of(fisheye, *model) ? Lens::kFisheye : Lens::kPinhole;
  if (options.lens && *options.lens != stated) {
    file.fail(kModel.front(), "'" + *model + "'", "what --lens says, or --lens left out");
  }
  return stated;
}

CameraCalibration read_camera(const CalibrationFile& file, Lens lens) {
  CameraCalibration camera;
  camera.K = file.camera_matrix(kCameraMatrix);
  camera.D =
      file.distortion(kDistortion, lens == Lens::kFisheye ? std::vector<int>{4} : std::vector<int>{0, 4, 5, 8, 12, 14});
  camera.R = file.rotation(kRotation);
  camera.P = file.projection(kProjection);
  return camera;
}

}  // namespace

bool is_camera_info(const CalibrationFile& file) {
  return file.has(kCameraMatrix) && file.has(kDistortion);
}

const std::string& projection_name(const CalibrationFile& file) {
  return file.name(kProjection);
}

StereoCalibration read_camera_info(const CalibrationFile& left, const CalibrationFile& right,
                                   const CalibrationOptions& options) {
  StereoCalibration calibration;
  calibration.path = right.path();
  calibration.lens = lens_of(left, options);
  if (lens_of(right, options) != calibration.lens) {
    right.fail(kModel.front(), "not the left camera's", "one model for both cameras");
  }
  calibration.left = read_camera(left, calibration.lens);
  calibration.right = read_camera(right, calibration.lens);
  calibration.rectified = true;
  calibration.image_size = left.image_size();
  const std::optional<cv::Size> right_size = right.image_size();
  if (calibration.image_size && right_size && *right_size != *calibration.image_size) {
    right.fail(
        "image_width, image_height", fmt::format("{} x {}", right_size->width, right_size->height),
        fmt::format("{} x {} px as in {}", calibration.image_size->width, calibration.image_size->height, left.path()));
  }
  if (calibration.left.P(0, 3) < 0.0 && calibration.right.P(0, 3) == 0.0) {
    left.fail(left.name(kProjection), "the right camera's", "the left camera's file first, then the right one's");
  }
  if (!left.has(kModel) && !options.lens && calibration.left.D.total() == 4) {
    calibration.warnings.push_back(four_coefficients_warning(left.path(), left.name(kDistortion)));
  }
  calibration.warnings.push_back(left.path() + ": states no reprojection error; taken on trust");
  return calibration;
}

}  // namespace markservo::stereo_camera
