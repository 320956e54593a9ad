#pragma once

// A drive as an LCM log for rfid-localizer, and what that made of it.

#include <markservo/RobotPose.hpp>
#include <string>
#include <vector>

#include "tests/experiments/localisation/recorded_drive.hpp"

namespace markservo::experiments {

// Writes RFID_TAG_HITS, SIM_BASE_TRUTH and, unless the robot is to have no encoders, WHEEL_ODOMETRY, in order of time.
// Throws std::runtime_error if the file cannot be written.
void write_log(const Drive& drive, bool with_odometry, const std::string& file);

// Every ROBOT_POSE of the log. Throws std::runtime_error if it cannot be read or a message cannot be decoded.
std::vector<RobotPose> read_poses(const std::string& file);

}  // namespace markservo::experiments
