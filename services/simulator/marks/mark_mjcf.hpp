#pragma once

// A printed mark as MuJoCo's MJCF.

#include <Eigen/Geometry>
#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::simulator {

// The name of a mark's geom, texture and material: "print:" + the mark's name.
std::string print_name(const std::string& mark);

// A mark's printed face lies this far before what it is glued to. Thicker, its visible side would shift the centre.
inline constexpr double kPrintThickness = 0.0002;  // m

// The geom of a mark whose printed face has pose `X` in its body: x right, z up along its edges, -y out of the print.
// Needs the material of its name.
std::string print_geom(const robot::MarkDescription& mark, const Eigen::Isometry3d& X);

}  // namespace markservo::simulator
