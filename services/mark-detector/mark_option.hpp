#pragma once

#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::mark_detector {

// A target described on the command line, of unknown size:
//   NAME=hue_min:hue_max:sat_min:sat_max:val_min:val_max[:plane|:free]
// Hue in degrees, 0 to 360, wrapping; saturation and value 0 to 1. Throws ConfigurationError.
robot::MarkDescription parse_mark(const std::string& text);

}  // namespace markservo::mark_detector
