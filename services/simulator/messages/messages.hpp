#pragma once

// The simulator's own structs as messages.

#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StereoFrame.hpp>
#include <opencv2/core.hpp>

#include "common/robot/robot_description.hpp"
#include "services/simulator/arm/arm_command.hpp"
#include "services/simulator/cameras/calibration_settings.hpp"
#include "services/simulator/cameras/image_pair.hpp"
#include "services/simulator/world/world_truth.hpp"

namespace markservo::simulator {

// Throws std::invalid_argument unless the command is for this arm's three joints.
ArmCommand arm_command(const JointCommand& message);

// As RC servos tell it: commanded, not measured. utime is the caller's.
JointState joint_state_message(const ArmReading& arm);

// All but the message's and the frame's identity and the control echo.
SimTruth truth_message(const WorldTruth& truth);

// Calibration as the settings falsify it, size and pixels. `jpeg_quality` 1 to 100; 0: raw.
StereoFrame frame_message(const robot::CameraDescription& cameras, const CalibrationSettings& settings,
                          const ImagePair& images, int jpeg_quality);

}  // namespace markservo::simulator
