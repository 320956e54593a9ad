#pragma once

#include <string>

namespace markservo::bus {

// A channel's name on a bus that robots share: "ROBOT/NAME", or "NAME" where `robot` is empty.
inline std::string robot_channel(const std::string& robot, const std::string& name) {
  return robot.empty() ? name : robot + "/" + name;
}

}  // namespace markservo::bus
