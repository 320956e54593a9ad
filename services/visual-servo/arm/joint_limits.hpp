#pragma once

// What the joints of robot.yaml allow.

#include "common/robot/robot_description.hpp"

namespace markservo::visual_servo {

// `q` brought inside the joint limits, rad.
robot::JointVector inside_limits(const robot::ArmDescription& arm, const robot::JointVector& q);

// The servos' own speeds, rad/s.
robot::JointVector servo_speeds(const robot::ArmDescription& arm);

}  // namespace markservo::visual_servo
