#pragma once

#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::robot {

// The mark `name`, the value of `option`. Throws ConfigurationError, with those that there are, unless it is one of the
// robot's; `robot_file` is where that was read from.
const MarkDescription& require_mark(const RobotDescription& robot, const std::string& option, const std::string& name,
                                    const std::string& robot_file);

}  // namespace markservo::robot
