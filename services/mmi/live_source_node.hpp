#pragma once

#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <memory>
#include <optional>
#include <string>

#include "common/bus/bus.hpp"
#include "common/robot/robot_description.hpp"
#include "services/mmi/control/command_sender_node.hpp"
#include "services/mmi/source.hpp"
#include "services/mmi/stop/stop_requester.hpp"

namespace markservo::mmi {

// The bus: heard by one subscription of all channels, told STOP, and what an operator commands.
class LiveSourceNode final : public Source {
 public:
  // `typed`: as what a person knows the commands that mend. `command_token`: who shows it may command; empty: nobody.
  LiveSourceNode(const robot::RobotDescription& robot, const std::string& tag_field,
                 const text::TypedCommand& typed = {}, const std::string& command_token = {});

  // Subscribes and advertises. `bus` must outlive this.
  void start(bus::Bus& bus);
  // Time passes: every 0.05 s or oftener.
  void tick();

  std::unique_ptr<Shown> shown() override;
  WorldReader& world() override { return world_; }
  std::string stop(const std::string& reason) override;
  const VersionedText& stop_state() const override { return stop_state_; }
  Desk* desk() override { return desk_ ? &*desk_ : nullptr; }

 private:
  void on_message(const bus::HeardBytes& message);
  void on_stop_state(const StopState& state);
  void on_stop(const StopRequest& request);
  void send_stop();

  WorldReader world_;
  StopRequester requester_;
  std::optional<Desk> desk_;
  std::optional<CommandSenderNode> commands_;
  VersionedText stop_state_;
  std::string prefix_;  // of the robot's channels
  bus::Bus* bus_ = nullptr;
  std::optional<bus::Publisher<StopRequest>> stops_;
};

}  // namespace markservo::mmi
