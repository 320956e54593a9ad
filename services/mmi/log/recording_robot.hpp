#pragma once

#include <optional>
#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::mmi {

struct RecordedRobot {
  std::optional<robot::RobotDescription> description;  // nothing: the manifest has none
  std::string path;                                    // of its robot.yaml when it was recorded
  std::string robot;                                   // the channels' prefix
  std::string note;                                    // what a person wrote to it
};

// What the recording in `folder` knows of its robot; all empty where it is no folder with a manifest. Throws
// ConfigurationError for a manifest that cannot be read or a robot.yaml in it that is none.
RecordedRobot recorded_robot(const std::string& folder);

}  // namespace markservo::mmi
