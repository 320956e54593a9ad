#pragma once

#include "common/robot/robot_description.hpp"

namespace markservo::simulator {

// Where the joints shall go.
struct ArmCommand {
  robot::JointVector position = robot::JointVector::Zero();     // rad, clamped to the joints' limits
  robot::JointVector speed_limit = robot::JointVector::Zero();  // rad/s, above 0
  double gripper_opening = 0.0;                                 // m, clamped to the gripper's range
  double gripper_force = 0.0;                                   // N, clamped to the gripper's
};

// What the arm's controller knows about itself: its ramps.
struct ArmReading {
  robot::JointVector position = robot::JointVector::Zero();  // rad
  robot::JointVector speed = robot::JointVector::Zero();     // rad/s
  double gripper_opening = 0.0;                              // m
  bool moving = false;
};

}  // namespace markservo::simulator
