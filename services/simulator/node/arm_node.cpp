#include "services/simulator/node/arm_node.hpp"

#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <string>

#include "common/messages/motion_messages.hpp"
#include "services/simulator/messages/arm_messages.hpp"

namespace markservo::simulator {

ArmNode::ArmNode(bus::Bus& bus, Simulation& simulation)
    : simulation_(&simulation), states_(bus.advertise(channels::kJointState)) {}

CommandAnswer ArmNode::on_command(const JointCommand& message) {
  const motion::OfferedCommand offered{messages::command_stamp(message), message.joint_session};
  return simulation_->command(offered, message.frame_seq, arm_command(message));
}

void ArmNode::drop_unless_obeyed(const JointCommand& message, const CommandAnswer& answer) const {
  const std::string command = "command for frame " + std::to_string(message.frame_seq) + " ";
  const std::string joint = answer.joint ? "joint " + simulation_->robot().arm->joints[*answer.joint].name + ": " : "";
  switch (answer.verdict) {
    case motion::CommandVerdict::kObeyed:
    case motion::CommandVerdict::kLatched:      // commands go on while the arm is stopped
    case motion::CommandVerdict::kBeforeReset:  // and those under way at a reset come late
      break;
    default:
      messages::drop(joint + command + motion::describe(answer.verdict));
  }
}

void ArmNode::publish() {
  JointState message = joint_state_message(faults_.apply(simulation_->settings().faults, simulation_->world().arm()));
  message.utime = simulation_->utime();
  states_.publish(message);
}

}  // namespace markservo::simulator
