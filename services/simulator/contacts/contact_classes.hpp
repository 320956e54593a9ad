#pragma once

// Who touches whom in the MuJoCo model: the arm's parts never each other, and nothing pushes the base, which goes where
// its wheels take it; all else everything.

namespace markservo::simulator {

// The room and its furniture have MuJoCo's defaults, contype 1 and conaffinity 1.
inline constexpr const char* kArmContact = "contype=\"3\" conaffinity=\"0\" group=\"1\"";
inline constexpr const char* kBookContact = "contype=\"3\" conaffinity=\"1\"";
inline constexpr const char* kBaseContact = "contype=\"0\" conaffinity=\"2\" group=\"1\"";
inline constexpr const char* kNoContact = "contype=\"0\" conaffinity=\"0\" mass=\"0\"";

// Sub-millimetre stiffness: books neither sink nor creep.
inline constexpr const char* kStiff = "solref=\"0.005 1\" solimp=\"0.95 0.99 0.001\"";

// The group of the robot's own geoms; all others are in group 0. Its sonars do not hear itself.
inline constexpr int kRobotGroup = 1;

}  // namespace markservo::simulator
