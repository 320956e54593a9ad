#pragma once

#include <cstdint>
#include <markservo/JointCommand.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/TargetPose.hpp>
#include <memory>
#include <optional>
#include <string>

#include "common/bus/service.hpp"
#include "services/visual-servo/servo_state_machine.hpp"

namespace markservo::visual_servo {

// SERVO_GOAL, TARGET_POSE, JOINT_STATE and STOP_STATE in; JOINT_COMMAND and SERVO_STATUS out, one of each per
// TARGET_POSE. Before the first JOINT_STATE there is only the status (stale): no command could be sent that holds.
class VisualServoNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void start(bus::Bus& bus) override;

 private:
  void handle(const TargetPose& pose);
  void tell(const Status& status);

  std::string law_ = "resolved-rate";
  std::string stop_device_ = "arm";
  Parameters parameters_;
  std::unique_ptr<ServoStateMachine> machine_;
  State state_;
  bus::Bus* bus_ = nullptr;
  std::optional<bus::Publisher<JointCommand>> commands_;
  std::optional<bus::Publisher<ServoStatus>> statuses_;
  std::optional<ServoState> told_;
};

}  // namespace markservo::visual_servo
