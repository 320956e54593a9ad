#pragma once

#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::robot {

// Throws ConfigurationError unless `device`, the value of `option`, is one of the robot's; `robot_file` is where it was
// read from.
void require_stop_device(const RobotDescription& robot, const std::string& option, const std::string& device,
                         const std::string& robot_file);

}  // namespace markservo::robot
