#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::mmi {

// `scene` of a hello: what stands still. `tag_field`: a name, or empty for the field in use. Throws ConfigurationError
// if there is none of that name.
nlohmann::ordered_json scene_json(const robot::RobotDescription& robot, const std::string& tag_field);

// The colour in the middle of the interval, as "#rrggbb".
std::string colour_text(const robot::ColourInterval& colour);

}  // namespace markservo::mmi
