#pragma once

#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::mmi {

// config/robot.yaml's.
inline const robot::RobotDescription& robot_of_the_project() {
  static const robot::RobotDescription robot =
      robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
  return robot;
}

}  // namespace markservo::mmi
