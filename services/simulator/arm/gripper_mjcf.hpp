#pragma once

// The gripper as MuJoCo's MJCF.

#include <string>

#include "common/robot/robot_description.hpp"
#include "services/simulator/arm/gripper_settings.hpp"

namespace markservo::simulator {

// Bodies, boxes and joints of the fingers; each joint's angle is its way from the middle, m.
inline constexpr const char* kFingers[] = {"finger_left", "finger_right"};
inline constexpr const char* kGripSite = "grip_point";
inline constexpr double kFingerDamping = 200.0;  // N s/m, of each finger's joint

// Both fingers and the grip point, in the forearm's body. Needs the material matt.
std::string gripper_bodies(const robot::ArmDescription& arm, const GripperSettings& settings);

// One motor drives both fingers, as in a parallel gripper: they stay at equal distance from the middle.
std::string gripper_equality();

}  // namespace markservo::simulator
