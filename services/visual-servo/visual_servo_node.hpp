#pragma once

#include <cstdint>
#include <markservo/channels.hpp>
#include <memory>
#include <optional>
#include <string>

#include "common/bus/service.hpp"
#include "common/motion/mover_watch.hpp"
#include "services/visual-servo/decisions/servo_state_machine.hpp"

namespace markservo::visual_servo {

// SERVO_GOAL, TARGET_POSE, JOINT_STATE and STOP_STATE in; JOINT_COMMAND and SERVO_STATUS out, one of each per
// TARGET_POSE. Before the first JOINT_STATE there is only the status (stale): no command could be sent that holds. When
// two claim to be the arm, or to see for it, STOP goes out until the arm is latched.
class VisualServoNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void start(bus::Bus& bus) override;

 private:
  struct Told {
    ServoState state;
    std::string notice;  // of others
  };
  void on_stop(const StopState& stop);
  void on_joints(const JointState& joints);
  void on_goal(const ServoGoal& goal);
  void on_pose(const TargetPose& pose);
  void after_input();
  void tell(const Status& status);

  std::string law_ = "resolved-rate";
  std::string stop_device_ = "arm";
  Parameters parameters_;
  std::unique_ptr<ServoStateMachine> machine_;
  State state_;
  bus::Bus* bus_ = nullptr;
  std::optional<motion::MoverWatch> arm_;
  std::optional<JointSample> strangers_;  // the newest sample of another than the arm, which may be the next one
  std::optional<bus::Publisher<StopRequest>> stops_;
  std::optional<bus::Publisher<JointCommand>> commands_;
  std::optional<bus::Publisher<ServoStatus>> statuses_;
  std::optional<Told> told_;
};

}  // namespace markservo::visual_servo
