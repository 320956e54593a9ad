#include "common/robot/require_mark.hpp"

#include "common/robot/configuration_error.hpp"

namespace markservo::robot {

const MarkDescription& require_mark(const RobotDescription& robot, const std::string& option, const std::string& name,
                                    const std::string& robot_file) {
  if (const MarkDescription* mark = robot.find_mark(name)) return *mark;
  std::string allowed;
  for (const auto& mark : robot.marks) allowed += (allowed.empty() ? "" : ", ") + mark.name;
  throw ConfigurationError(option + " is '" + name + "'; allowed: a mark of " + robot_file + ": " + allowed);
}

}  // namespace markservo::robot
