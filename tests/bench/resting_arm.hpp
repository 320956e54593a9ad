#pragma once

#include <markservo/JointState.hpp>

#include "common/robot/robot_description.hpp"

namespace markservo::bench {

// An arm that stands at `joints` (rad), its gripper open; utime is the sender's.
inline JointState resting_arm(const robot::JointVector& joints) {
  constexpr double kGripperOpening = 0.05;  // m
  JointState state{};
  state.num_joints = robot::kNumJoints;
  state.position.assign(joints.data(), joints.data() + robot::kNumJoints);
  state.speed.assign(robot::kNumJoints, 0.0);
  state.measured = 1;
  state.gripper_opening = kGripperOpening;
  return state;
}

}  // namespace markservo::bench
