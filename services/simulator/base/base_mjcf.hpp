#pragma once

// The robot's base as MuJoCo's MJCF.

#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::simulator {

inline constexpr const char* kRobotBase = "robot_base";  // the body whose frame is C
inline constexpr const char* kBaseJoints[] = {"base_x", "base_y", "base_turn"};

// The robot's base and all that it carries: a body whose place the wheels decide, and no force. It is a box up to the
// plate that the arm stands on, and a mast that carries the cameras; its frame is C. `floor_z`: m in C; `carried`: the
// cameras and the arm as MJCF. Needs the material matt.
std::string robot_body(const robot::RobotDescription& robot, double floor_z, const std::string& carried);

}  // namespace markservo::simulator
