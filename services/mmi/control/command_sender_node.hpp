#pragma once

#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/bus.hpp"
#include "common/motion/command_sender.hpp"
#include "common/motion/sole_writer.hpp"
#include "services/mmi/control/desk.hpp"

namespace markservo::mmi {

// Sends what a Desk has to send, as TASK_COMMAND and STOP, and tells it what is answered.
class CommandSenderNode {
 public:
  // `desk` must outlive this; `stop_devices` as in robot.yaml.
  CommandSenderNode(Desk& desk, const std::vector<std::string>& stop_devices) : desk_(desk), sender_(stop_devices) {}

  // `bus` must outlive this.
  void start(bus::Bus& bus);
  void observe(const StopState& state);
  // Every 0.05 s or oftener.
  void tick();

 private:
  void observe(const TaskState& state);
  void send(const CommandToSend& to_send);

  Desk& desk_;
  motion::CommandSender sender_;
  motion::SoleWriter task_{"TASK_STATE"};
  bus::Bus* bus_ = nullptr;
  std::optional<bus::Publisher<StopRequest>> stops_;
  std::optional<bus::Publisher<TaskCommand>> commands_;
};

}  // namespace markservo::mmi
