#include "common/robot/stop_device.hpp"

#include <algorithm>

#include "common/robot/configuration_error.hpp"

namespace markservo::robot {

void require_stop_device(const RobotDescription& robot, const std::string& option, const std::string& device,
                         const std::string& robot_file) {
  const auto& devices = robot.stop_devices;
  if (std::find(devices.begin(), devices.end(), device) != devices.end()) return;
  std::string allowed;
  for (const auto& one : devices) allowed += (allowed.empty() ? "" : ", ") + one;
  throw ConfigurationError(option + " '" + device + "': allowed: stop_devices of " + robot_file + ": " + allowed);
}

}  // namespace markservo::robot
