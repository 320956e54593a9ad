#pragma once

// The sections of robot.yaml about the mobile base, its sonars, its RFID reader and the floor's tags.

#include "common/robot/robot_description.hpp"
#include "common/robot/yaml_section.hpp"

namespace markservo::robot {

// Reads and checks base, sonars, rfid and floor_tags, those that are there. Throws ConfigurationError.
void load_base_sections(YamlSection& root, RobotDescription& robot);

}  // namespace markservo::robot
