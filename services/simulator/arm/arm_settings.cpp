#include "services/simulator/arm/arm_settings.hpp"

#include <cstddef>

#include "common/geometry/degrees.hpp"
#include "common/robot/configuration_error.hpp"

namespace markservo::simulator {

const robot::ArmDescription& arm_of(const robot::RobotDescription& robot) {
  if (robot.arm) return *robot.arm;
  throw ConfigurationError("the simulator's robot has no arm; allowed: a robot.yaml with section 'arm'");
}

ArmSettings default_arm_settings(const robot::ArmDescription& arm) {
  ArmSettings settings;
  settings.start_yaw_deg = arm.home[0] * geometry::kDegreesPerRadian;
  settings.start_shoulder_deg = arm.home[1] * geometry::kDegreesPerRadian;
  settings.start_elbow_deg = arm.home[2] * geometry::kDegreesPerRadian;
  settings.start_opening = arm.gripper.opening_max;
  return settings;
}

void check_arm_settings(const ArmSettings& settings, const robot::ArmDescription& arm) {
  const double start[] = {settings.start_yaw_deg, settings.start_shoulder_deg, settings.start_elbow_deg};
  const char* names[] = {"arm.start_yaw_deg", "arm.start_shoulder_deg", "arm.start_elbow_deg"};
  constexpr double kRounding_deg = 1e-9;
  for (std::size_t i = 0; i < 3; ++i) {
    const double min = arm.joints[i].min * geometry::kDegreesPerRadian;
    const double max = arm.joints[i].max * geometry::kDegreesPerRadian;
    if (start[i] < min - kRounding_deg || start[i] > max + kRounding_deg) {
      refuse_setting(names[i], setting_text(start[i]),
                     "the joint's range in robot.yaml, " + setting_text(min) + " to " + setting_text(max));
    }
  }
  if (settings.start_opening > arm.gripper.opening_max) {
    refuse_setting("arm.start_opening", setting_text(settings.start_opening),
                   "up to the gripper's " + setting_text(arm.gripper.opening_max));
  }
}

}  // namespace markservo::simulator
