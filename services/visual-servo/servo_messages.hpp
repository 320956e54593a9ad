#pragma once

// Between messages and the servo core's own structs.

#include <markservo/channels.hpp>

#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

// Throws std::invalid_argument unless it has the arm's number of joints.
JointSample joint_sample(const JointState& message);

Goal goal_of(const ServoGoal& message);

PoseSample pose_sample(const TargetPose& message);

// The answers to `pose`; session and seq are the publisher's to fill.
JointCommand command_message(const Command& command, const TargetPose& pose);
ServoStatus status_message(const Status& status, const TargetPose& pose);

}  // namespace markservo::visual_servo
