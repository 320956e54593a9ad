#pragma once

// ROS's description of one camera, sensor_msgs/CameraInfo, as camera_calibration writes it into YAML files or the topic
// is printed: of a pair one file for each side, lengths in metres.

#include "services/stereo-camera/calibration/calibration_file.hpp"
#include "services/stereo-camera/calibration/stereo_calibration.hpp"

namespace markservo::stereo_camera {

// Whether the file describes one camera in that way.
bool is_camera_info(const CalibrationFile& file);

// The key by which it states its projection.
const std::string& projection_name(const CalibrationFile& file);

// Throws ConfigurationError.
StereoCalibration read_camera_info(const CalibrationFile& left, const CalibrationFile& right,
                                   const CalibrationOptions& options);

}  // namespace markservo::stereo_camera
