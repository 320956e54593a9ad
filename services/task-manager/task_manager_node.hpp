#pragma once

// The procedure on the bus.
//   in:  TASK_COMMAND, TARGET_POSE, JOINT_STATE, STOP_STATE, BASE_STATUS, SERVO_STATUS, each message in order of
//   arrival
//   out: TASK_STATE, one per SERVO_STATUS; SERVO_GOAL and, if the robot has a base, BASE_GOAL, when they are new and at
//        5 Hz of message time; STOP when two claim to be one of those that are listened to

#include <map>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <optional>
#include <string>
#include <utility>

#include "common/bus/service.hpp"
#include "common/motion/mover_watch.hpp"
#include "services/task-manager/base_reports.hpp"
#include "services/task-manager/command_queue.hpp"
#include "services/task-manager/procedure.hpp"

namespace markservo::task_manager {

class TaskManagerNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void start(bus::Bus& bus) override;

 private:
  void on_command(const TaskCommand& command);
  void on_pose(const TargetPose& pose);
  void on_joints(const JointState& joints);
  void on_stop(const StopState& stop);
  void on_base(const BaseStatus& status);
  void on_status(const ServoStatus& status);
  StopReport stop_report() const;
  motion::MoverWatch& watch(const std::string& device);
  void ask_for_stops();
  ServoReport servo_report(const ServoStatus& status);
  void send(const Goal& goal, const ServoStatus& status);
  void send(const DriveGoal& goal, const ServoStatus& status);
  void tell(const Output& output, std::int64_t utime);

  std::string arm_device_ = "arm";
  std::string base_device_ = "base";
  Parameters parameters_;
  robot::RobotDescription robot_;
  std::optional<Procedure> procedure_;
  State state_;
  Input input_;  // what has come since the last step
  BaseReports base_reports_;
  CommandQueue commands_;
  std::map<std::string, motion::MoverWatch> movers_;       // by device
  std::map<std::string, std::int64_t> stop_state_utimes_;  // us, likewise
  std::optional<ArmReport> strangers_;  // the newest of another than the arm, which may be the next one
  bool stopped_meanwhile_ = false;      // a device was latched since the last step
  std::int64_t stop_request_id_ = 0;
  std::pair<std::string, std::int64_t> asked_;  // the last STOP asked for: device and the wish's id
  std::optional<Output> told_;                  // what the log said last
  std::int64_t task_began_ = 0;                 // us

  bus::Bus* bus_ = nullptr;
  std::optional<bus::Publisher<ServoGoal>> goals_;
  std::optional<bus::Publisher<BaseGoal>> base_goals_;  // if the robot has a base
  std::optional<bus::Publisher<TaskState>> states_;
  std::optional<bus::Publisher<StopRequest>> stop_requests_;
};

}  // namespace markservo::task_manager
