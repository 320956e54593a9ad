#pragma once

#include <markservo/channels.hpp>

#include "services/simulator/arm/arm_command.hpp"

namespace markservo::simulator {

// Throws std::invalid_argument unless the command is for this arm's three joints.
ArmCommand arm_command(const JointCommand& message);

// The arm's state as RC servos tell it: commanded, not measured. utime is the caller's.
JointState joint_state_message(const ArmReading& arm);

}  // namespace markservo::simulator
