#pragma once

#include <markservo/channels.hpp>

#include "common/robot/robot_description.hpp"
#include "services/simulator/cameras/calibration_settings.hpp"
#include "services/simulator/cameras/image_pair.hpp"

namespace markservo::simulator {

// A frame with size, pixels and the calibration as the settings falsify it. `jpeg_quality` 1 to 100; 0: raw.
StereoFrame frame_message(const robot::CameraDescription& cameras, const CalibrationSettings& settings,
                          const ImagePair& images, int jpeg_quality);

}  // namespace markservo::simulator
