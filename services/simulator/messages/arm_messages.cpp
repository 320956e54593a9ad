#include "services/simulator/messages/arm_messages.hpp"

#include <cstddef>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <stdexcept>
#include <string>

#include "services/simulator/messages/joint_values.hpp"

namespace markservo::simulator {

ArmCommand arm_command(const JointCommand& message) {
  if (message.num_joints != robot::kNumJoints) {
    throw std::invalid_argument("num_joints is " + std::to_string(message.num_joints) +
                                "; allowed: " + std::to_string(robot::kNumJoints));
  }
  ArmCommand command;
  for (int i = 0; i < robot::kNumJoints; ++i) {
    command.position[i] = message.position[static_cast<std::size_t>(i)];
    command.speed_limit[i] = message.speed_limit[static_cast<std::size_t>(i)];
  }
  command.gripper_opening = message.gripper_opening;
  command.gripper_force = message.gripper_force;
  return command;
}

JointState joint_state_message(const ArmReading& arm) {
  JointState message{};
  message.num_joints = robot::kNumJoints;
  message.position = joint_values(arm.position);
  message.speed = joint_values(arm.speed);
  message.measured = 0;
  message.moving = arm.moving ? 1 : 0;
  message.gripper_opening = arm.gripper_opening;
  message.contact_known = 0;
  message.contact = 0;
  return message;
}

}  // namespace markservo::simulator
