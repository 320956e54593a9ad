#pragma once

// The cameras that pictures of one size are published for, and how they are told to a person.

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "services/stereo-camera/calibration/camera_geometry.hpp"
#include "services/stereo-camera/calibration/rectifier.hpp"

namespace markservo::stereo_camera {

struct ChosenCameras {
  geometry::StereoCamera camera;       // of the published pictures
  std::optional<Rectifier> rectifier;  // where there is a calibration
  std::vector<std::string> warnings;   // what was taken on trust
  std::string summary;                 // one line: focal length, baseline, how much of the pictures is left
};

// Throws ConfigurationError where the pictures are of another size than the geometry says, or what comes out can be no
// view of such cameras.
ChosenCameras choose_cameras(const CameraGeometry& geometry, cv::Size picture_size);

}  // namespace markservo::stereo_camera
