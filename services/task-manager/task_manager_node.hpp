#pragma once

// The procedure on the bus.
//   in:  TASK_COMMAND, TARGET_POSE, JOINT_STATE, STOP_STATE, BASE_STATUS, SERVO_STATUS, each message in order of
//   arrival
//   out: TASK_STATE, one per SERVO_STATUS; SERVO_GOAL and, if the robot has a base, BASE_GOAL, when they are new and at
//        5 Hz of message time; STOP when two claim to be one of those that are listened to

#include <markservo/channels.hpp>
#include <optional>
#include <string>

#include "common/bus/service.hpp"
#include "services/task-manager/inputs/next_input.hpp"
#include "services/task-manager/inputs/stop_devices.hpp"
#include "services/task-manager/procedure.hpp"
#include "services/task-manager/task_log.hpp"

namespace markservo::task_manager {

class TaskManagerNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void start(bus::Bus& bus) override;

 private:
  struct Publishers {
    bus::Publisher<ServoGoal> servo_goals;
    bus::Publisher<TaskState> states;
    bus::Publisher<StopRequest> stops;
    std::optional<bus::Publisher<BaseGoal>> base_goals;  // if the robot has a base
  };

  void on_command(const TaskCommand& message);
  void on_pose(const TargetPose& message);
  void on_joints(const JointState& message);
  void on_stop(const StopState& message);
  void on_base(const BaseStatus& message);
  void on_status(const ServoStatus& message);
  ServoReport believed(const ServoStatus& message);
  void ask_for_stops();
  void publish(const Output& output, const ServoStatus& status);
  void tell(const Output& output, std::int64_t utime);

  std::string arm_device_ = "arm";
  std::string base_device_ = "base";
  Parameters parameters_;
  robot::RobotDescription robot_;
  std::optional<Procedure> procedure_;
  State state_;
  StopDevices stop_devices_;
  NextInput next_input_;
  TaskLog log_;
  bus::Bus* bus_ = nullptr;
  std::optional<Publishers> out_;
};

}  // namespace markservo::task_manager
