#pragma once

// Between messages and the navigator core's own structs.

#include <markservo/channels.hpp>

#include "services/base-navigator/answer_pacing.hpp"
#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {

OdometrySample odometry_sample(const WheelOdometry& message);
PoseSample pose_sample(const RobotPose& message);
SonarScanSample scan_sample(const SonarScan& message);
Goal goal_of(const BaseGoal& message);

OdometryId identity(const WheelOdometry& message);
// The odometry that the pose answers, at the pose's own time.
OdometryId identity(const RobotPose& message);

// The answers to an odometry; session and seq are the publisher's to fill.
BaseCommand command_message(const Command& command, const OdometryId& odometry);
BaseStatus status_message(const Status& status, const OdometryId& odometry);

}  // namespace markservo::base_navigator
