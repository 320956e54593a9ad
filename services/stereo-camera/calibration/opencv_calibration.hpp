#pragma once

// Calibrations of both cameras together, as users of OpenCV write them.

#include "services/stereo-camera/calibration/calibration_file.hpp"
#include "services/stereo-camera/calibration/stereo_calibration.hpp"

namespace markservo::stereo_camera {

// The cameras from `intrinsics`, how they stand from `extrinsics`, which may be the same file; it then has to state an
// error, too. An error that either states has to be small enough. Lengths are still in the file's unit. Throws
// ConfigurationError.
StereoCalibration read_opencv_calibration(const CalibrationFile& intrinsics, const CalibrationFile& extrinsics,
                                          const CalibrationOptions& options);

// The factor that makes metres of the calibration's lengths; throws ConfigurationError where it cannot be.
double metres_per_unit(const CalibrationFile& extrinsics, const StereoCalibration& calibration,
                       const CalibrationOptions& options);

}  // namespace markservo::stereo_camera
