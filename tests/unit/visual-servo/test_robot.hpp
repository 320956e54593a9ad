#pragma once

// The robot that the servo is tried on, and the goals that it is given.

#include <Eigen/Core>
#include <cstdint>

#include "common/geometry/degrees.hpp"
#include "common/robot/robot_description.hpp"
#include "services/visual-servo/decisions/servo_state_machine.hpp"

namespace markservo::visual_servo::test {

inline constexpr double kDegree = geometry::radians(1.0);

inline const Eigen::Vector3d kGripFromTarget{0.0, 0.015, -0.052};  // m, in the axes of C, from the red book's mark

inline const Eigen::Matrix3d kCovariance = Eigen::Matrix3d::Identity() * 4e-8;  // m^2, of a mark seen to 0.2 mm

// config/robot.yaml
robot::RobotDescription the_robot();

// The red book's grip, with the hand open and the servo's own tolerance. `utime` (us): of the joints.
Goal grip_goal(std::int64_t utime, std::int64_t id);

// The present goal, as its sender says it again at `utime` (us).
void repeat_goal(const ServoStateMachine& machine, State& state, std::int64_t utime);

}  // namespace markservo::visual_servo::test
