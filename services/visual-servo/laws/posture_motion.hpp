#pragma once

// Coordinated joint motion towards a posture: straight in joint space, all joints end together.

#include "common/robot/robot_description.hpp"

namespace markservo::visual_servo {

struct PostureMotionParameters {
  double joint_speed = 1.5;         // rad/s (86 degrees/s) of the joint that has farthest to go
  double joint_acceleration = 8.0;  // rad/s^2; full speed after 0.2 s
};

// The next joint step (rad) from the commanded posture `q_command` towards `q_goal`. `grip_speed`: limit of the grip
// point, m/s; `speed_before`: speed of the fastest joint in the last step, rad/s. The last step ends on the goal.
robot::JointVector posture_step(const robot::ArmDescription& arm, const PostureMotionParameters& parameters,
                                const robot::JointVector& q_command, const robot::JointVector& q_goal, double seconds,
                                double grip_speed, double speed_before);

}  // namespace markservo::visual_servo
