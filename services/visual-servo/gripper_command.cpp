// The gripper's part of the command.

#include <algorithm>

#include "services/visual-servo/servo_state_machine.hpp"

namespace markservo::visual_servo {

void ServoStateMachine::set_gripper(const Goal& goal, State& state) const {
  set_opening(goal.gripper_opening, state);
  state.command.gripper_force = std::clamp(goal.gripper_force, 0.0, arm_.gripper.force_max);
}

void ServoStateMachine::set_opening(double opening, State& state) const {
  const double allowed = std::clamp(opening, 0.0, arm_.gripper.opening_max);
  if (allowed == state.command.gripper_opening) return;
  state.command.gripper_opening = allowed;
  state.gripper_utime = state.joints.newest().utime;
}

// The gripper stays as it is: one that was moving does not go on, one that presses goes on pressing.
void ServoStateMachine::adopt_gripper(State& state) const {
  const JointSample& now = state.joints.newest();
  const bool holds = state.gripper.pressing || (now.contact && state.command.gripper_opening < now.gripper_opening);
  if (!holds) set_opening(now.gripper_opening, state);
}

}  // namespace markservo::visual_servo
