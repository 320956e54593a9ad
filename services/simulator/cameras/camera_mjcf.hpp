#pragma once

// The camera pair as MuJoCo's MJCF.

#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::simulator {

inline constexpr const char* kLeftCamera = "left";
inline constexpr const char* kRightCamera = "right";

// Throws ConfigurationError if the cameras are not what the renderer can do: fx = fy and the principal point in the
// image's middle.
void require_drawable(const robot::CameraDescription& cameras);

// deg, full vertical angle of view.
double vertical_view_deg(const robot::CameraDescription& cameras);

// Both cameras, in a body whose frame is C.
std::string camera_pair(const robot::CameraDescription& cameras);

}  // namespace markservo::simulator
