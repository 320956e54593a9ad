#pragma once

// The arm as MuJoCo's MJCF.

#include <string>

#include "common/robot/robot_description.hpp"
#include "services/simulator/arm/arm_settings.hpp"
#include "services/simulator/arm/gripper_settings.hpp"
#include "services/simulator/cameras/calibration_settings.hpp"

namespace markservo::simulator {

inline constexpr const char* kArmColumn = "column";  // the body that carries all others of the arm
inline constexpr const char* kArmJoints[] = {"yaw", "shoulder", "elbow"};
inline constexpr double kJointDamping = 60.0;  // N m s/rad, of each joint

// The arm as it really is in the simulated world: robot.yaml's with the settings' calibration errors.
robot::ArmDescription true_arm(const robot::ArmDescription& described, const CalibrationSettings& calibration,
                               const ArmSettings& settings);

// The bodies of `arm` (the true one) with hand, hand mark and gripper, in a body whose frame is C. Needs the materials
// matt and those of the marks.
std::string arm_bodies(const robot::RobotDescription& robot, const robot::ArmDescription& arm,
                       const GripperSettings& gripper);

}  // namespace markservo::simulator
