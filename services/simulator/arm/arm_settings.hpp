#pragma once

// Settings `arm.*`: how long the links really are, and where arm and gripper are at a reset.

#include "common/robot/robot_description.hpp"
#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct ArmSettings {
  double link_scale = 1.0;
  double start_yaw_deg = 0.0;
  double start_shoulder_deg = 0.0;
  double start_elbow_deg = 0.0;
  double start_opening = 0.0;
};

inline constexpr Setting<ArmSettings> kArmSettings[] = {
    {"arm.link_scale", &ArmSettings::link_scale, 0.8, 1.2, TakesEffect::kAtReset,
     "true lengths of all links over robot.yaml's"},
    {"arm.start_yaw_deg", &ArmSettings::start_yaw_deg, -180.0, 180.0, TakesEffect::kAtReset, "deg, at a reset"},
    {"arm.start_shoulder_deg", &ArmSettings::start_shoulder_deg, -180.0, 180.0, TakesEffect::kAtReset,
     "deg, at a reset"},
    {"arm.start_elbow_deg", &ArmSettings::start_elbow_deg, -180.0, 180.0, TakesEffect::kAtReset, "deg, at a reset"},
    {"arm.start_opening", &ArmSettings::start_opening, 0.0, 0.2, TakesEffect::kAtReset, "m, gripper at a reset"},
};

// Throws ConfigurationError if the robot has none.
const robot::ArmDescription& arm_of(const robot::RobotDescription& robot);

// The start at `arm`'s home with the gripper open.
ArmSettings default_arm_settings(const robot::ArmDescription& arm);

// Throws ConfigurationError unless the start posture is inside the arm's limits and the opening inside the gripper's.
void check_arm_settings(const ArmSettings& settings, const robot::ArmDescription& arm);

}  // namespace markservo::simulator
