#pragma once

// The drive from above.

#include <markservo/SimTruth.hpp>
#include <string>

#include "common/robot/robot_description.hpp"
#include "tests/experiments/drive_truth.hpp"

namespace markservo::experiments {

// Writes a PNG: the tag field in use, the true way and the one that ROBOT_POSE told, the robot's outline at both ends,
// the goal, the marks of `truth` as seen from the way's end, and a scale. Writes nothing when there was no drive.
void write_drive_picture(const std::string& path, const robot::RobotDescription& robot, const DriveWatch& drive,
                         const Pose2& goal, const SimTruth& truth);

}  // namespace markservo::experiments
