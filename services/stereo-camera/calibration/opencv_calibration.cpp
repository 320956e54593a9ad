#include "services/stereo-camera/calibration/opencv_calibration.hpp"

#include <fmt/core.h>

#include <cmath>

namespace markservo::stereo_camera {
namespace {

using Keys = CalibrationFile::Keys;

const std::vector<int> kPinholeCounts{4, 5, 8, 12, 14};
const std::vector<int> kFisheyeCounts{4};

struct CameraKeys {
  Keys K, D, R, P;
};
const CameraKeys kLeft{{"K1", "M1", "cameraMatrix1", "camera_matrix_1", "mtx1", "mtxL", "K_l"},
                       {"D1", "distCoeffs1", "dist_coeffs_1", "dist1", "distL", "D_l"},
                       {"R1"},
                       {"P1"}};
const CameraKeys kRight{{"K2", "M2", "cameraMatrix2", "camera_matrix_2", "mtx2", "mtxR", "K_r"},
                        {"D2", "distCoeffs2", "dist_coeffs_2", "dist2", "distR", "D_r"},
                        {"R2"},
                        {"P2"}};
const Keys kRotation{"R", "rotation"};
const Keys kTranslation{"T", "translation"};

void read_intrinsics(const CalibrationFile& file, const CalibrationOptions& options, StereoCalibration& calibration) {
  calibration.lens = options.lens.value_or(Lens::kPinhole);
  const auto& counts = calibration.lens == Lens::kFisheye ? kFisheyeCounts : kPinholeCounts;
  calibration.left.K = file.camera_matrix(kLeft.K);
  calibration.left.D = file.distortion(kLeft.D, counts);
  calibration.right.K = file.camera_matrix(kRight.K);
  calibration.right.D = file.distortion(kRight.D, counts);
  const bool left_has_four = calibration.left.D.total() == 4;
  if (!options.lens && (left_has_four || calibration.right.D.total() == 4)) {
    calibration.warnings.push_back(
        four_coefficients_warning(file.path(), file.name(left_has_four ? kLeft.D : kRight.D)));
  }
  calibration.image_size = file.image_size();
}

void read_extrinsics(const CalibrationFile& file, StereoCalibration& calibration) {
  const bool any_rectification = file.has(kLeft.R) || file.has(kRight.R) || file.has(kLeft.P) || file.has(kRight.P);
  const bool relative = file.has(kRotation) && file.has(kTranslation);
  if (relative) calibration.relative = RelativePose{file.rotation(kRotation), file.vector3(kTranslation)};
  if (!any_rectification && !relative) {
    file.missing(file.has(kRotation) ? kTranslation.front() : kRotation.front(), "R and T, or R1, R2, P1 and P2");
  }
  if (!any_rectification) return;
  calibration.left.R = file.rotation(kLeft.R);
  calibration.right.R = file.rotation(kRight.R);
  calibration.left.P = file.projection(kLeft.P);
  calibration.right.P = file.projection(kRight.P);
  calibration.rectified = true;
}

void check_error(const CalibrationFile& file, const Keys& keys, const CalibrationOptions& options) {
  const std::optional<double> error_px = file.number(keys);
  if (!error_px) return;
  if (*error_px < 0.0) file.fail(file.name(keys), fmt::format("{:.6g} px", *error_px), "0 or more");
  if (*error_px <= options.max_error_px || options.accept_any_error) return;
  file.fail(file.name(keys), fmt::format("{:.6g} px", *error_px),
            fmt::format("up to {:.6g} px (calibrate again, or pass --accept-rms)", options.max_error_px));
}

// What both files state; they may be one. One file is where users write the error too, the sample of two never does.
void check_errors(const CalibrationFile& intrinsics, const CalibrationFile& extrinsics,
                  const CalibrationOptions& options, StereoCalibration& calibration) {
  const Keys rms{"rms", "RMS", "reprojection_error", "avg_reprojection_error"};
  if (!intrinsics.has(rms) && !extrinsics.has(rms)) {
    if (intrinsics.path() == extrinsics.path() && !options.accept_any_error) {
      intrinsics.missing(rms.front(), "the calibration's reprojection error in px (or pass --accept-rms)");
    }
    calibration.warnings.push_back(intrinsics.path() + ": states no reprojection error; taken on trust");
  }
  for (const CalibrationFile* file : {&intrinsics, &extrinsics}) {
    check_error(*file, rms, options);
    check_error(*file, {"epipolar_error", "epipolar_rms", "epipolar"}, options);
  }
}

// Between the lenses, in the file's unit.
double stated_length(const StereoCalibration& calibration) {
  if (calibration.relative) return cv::norm(calibration.relative->T);
  return std::abs(calibration.right.P(0, 3) / calibration.right.P(0, 0));
}

}  // namespace

StereoCalibration read_opencv_calibration(const CalibrationFile& intrinsics, const CalibrationFile& extrinsics,
                                          const CalibrationOptions& options) {
  StereoCalibration calibration;
  calibration.path = extrinsics.path();
  read_intrinsics(intrinsics, options, calibration);
  read_extrinsics(extrinsics, calibration);
  check_errors(intrinsics, extrinsics, options, calibration);
  return calibration;
}

double metres_per_unit(const CalibrationFile& extrinsics, const StereoCalibration& calibration,
                       const CalibrationOptions& options) {
  if (!options.board_square) return options.metres_per_unit.value_or(1.0);
  const Keys square{"square_size", "squareSize"};
  if (const std::optional<double> stated = extrinsics.number(square)) {
    if (!(*stated > 0.0)) extrinsics.fail(extrinsics.name(square), fmt::format("{:.6g}", *stated), "above 0");
    return *options.board_square / *stated;
  }
  const double squares = stated_length(calibration);
  if (squares > kMaxSquaresOfBaseline) {
    extrinsics.fail(calibration.relative ? extrinsics.name(kTranslation) : "P2",
                    fmt::format("{:.6g} squares between the cameras", squares),
                    fmt::format("up to {:.6g} with --board-square (if it is not in squares, its unit: "
                                "--metres-per-unit 0.001 for mm, 0.01 for cm, 0.0254 for inches)",
                                kMaxSquaresOfBaseline));
  }
  return *options.board_square;
}

}  // namespace markservo::stereo_camera
