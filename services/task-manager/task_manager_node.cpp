#include "services/task-manager/task_manager_node.hpp"

#include <algorithm>
#include <cstdint>
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
#include <string>

#include "common/bus/options.hpp"
#include "common/logging/log.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/stop_device.hpp"
#include "services/task-manager/options.hpp"
#include "services/task-manager/task_messages.hpp"

namespace markservo::task_manager {
namespace {

using messages::drop;
using messages::stamp_of;

}  // namespace

void TaskManagerNode::add_options(CLI::App& app) {
  const bus::Options add(app);
  add.option("--arm-device", arm_device_, "The arm's name in STOP_STATE").show_default();
  add.option("--base-device", base_device_, "The base's name in STOP_STATE").show_default();
  add_parameter_options(app, parameters_);
}

void TaskManagerNode::configure(const std::string& robot_file) {
  robot_ = robot::load_robot_description(robot_file);
  robot::require_stop_device(robot_, "--arm-device", arm_device_, robot_file);
  if (robot_.base) robot::require_stop_device(robot_, "--base-device", base_device_, robot_file);
  if (parameters_.carry.place_radius_max < parameters_.carry.place_radius_min) {
    throw ConfigurationError("place-radius-max is " + std::to_string(parameters_.carry.place_radius_max) +
                             " m; allowed: at least place-radius-min, " +
                             std::to_string(parameters_.carry.place_radius_min) + " m");
  }
  if (robot_.floor_tags) robot_.floor_tags->field(parameters_.drive.tag_field);  // throws if there is none
  stop_devices_ = StopDevices(robot_.stop_devices);
  procedure_.emplace(robot_, parameters_);
}

void TaskManagerNode::start(bus::Bus& bus) {
  bus_ = &bus;
  out_.emplace(Publishers{bus.advertise(channels::kServoGoal), bus.advertise(channels::kTaskState),
                          bus.advertise(channels::kStop), std::nullopt});
  if (robot_.base) {
    out_->base_goals.emplace(bus.advertise(channels::kBaseGoal));
    bus.on_each(channels::kBaseStatus, [this](const BaseStatus& status) { on_base(status); });
  }
  bus.on_each(channels::kTaskCommand, [this](const TaskCommand& command) { on_command(command); });
  bus.on_each(channels::kStopState, [this](const StopState& stop) { on_stop(stop); });
  bus.on_each(channels::kJointState, [this](const JointState& joints) { on_joints(joints); });
  bus.on_each(channels::kTargetPose, [this](const TargetPose& pose) { on_pose(pose); });
  bus.on_each(channels::kServoStatus, [this](const ServoStatus& status) { on_status(status); });
  bus.need(channels::kServoStatus);
  bus.need(channels::kTargetPose);
  bus.need(channels::kJointState);
  bus.need(channels::kStopState);
}

void TaskManagerNode::on_command(const TaskCommand& message) {
  const Command command = command_of(message);
  const std::int64_t now = stop_devices_.watch(arm_device_).now();
  if (now != 0 && command.kind != CommandKind::kAbort) {
    drop(state_.inbox.why_stale({command.session, command.id, command.utime}, now));
  }
  next_input_.observe(command);
}

void TaskManagerNode::on_pose(const TargetPose& message) {
  const motion::StreamHeard heard =
      stop_devices_.watch(arm_device_).hear_stream(channels::kTargetPose.name, stamp_of(message));
  ask_for_stops();
  drop(motion::why_dropped(heard));
  next_input_.observe(message.utime, mark_reports(message));
}

void TaskManagerNode::on_joints(const JointState& message) {
  const ArmReport report = arm_report(message);
  const motion::ReportHeard heard =
      stop_devices_.watch(arm_device_).hear_report(channels::kJointState.name, stamp_of(message));
  ask_for_stops();
  if (heard == motion::ReportHeard::kForeign) next_input_.observe_stranger(report);
  drop(motion::why_dropped(heard));
  next_input_.observe(report);
}

void TaskManagerNode::on_stop(const StopState& message) {
  if (!stop_devices_.has(message.device)) return;
  const motion::ReportHeard heard =
      stop_devices_.hear_stop_state(message.device, stamp_of(message), message.latched != 0, message.reason);
  ask_for_stops();
  if (heard == motion::ReportHeard::kReplaced && message.device == arm_device_) {
    next_input_.replace_arm(message.session, !state_.arm_goals.none_yet());
  }
  drop(motion::why_dropped(heard));
}

void TaskManagerNode::on_base(const BaseStatus& message) {
  const motion::StreamHeard heard =
      stop_devices_.watch(base_device_).hear_stream(channels::kBaseStatus.name, stamp_of(message));
  ask_for_stops();
  drop(motion::why_dropped(heard));
  next_input_.observe(base_report(message, out_->base_goals->session()));
}

// A second visual-servo's word is answered, so that who waits for the answer goes on, but not believed.
ServoReport TaskManagerNode::believed(const ServoStatus& message) {
  const motion::StreamHeard heard =
      stop_devices_.watch(arm_device_).hear_stream(channels::kServoStatus.name, stamp_of(message));
  ask_for_stops();
  const std::string why = motion::why_dropped(heard);
  if (heard == motion::StreamHeard::kLate) drop(why);
  ServoReport report = servo_report(message, out_->servo_goals.session());
  if (why.empty()) return report;
  report.state = ServoState::kStale;
  report.settled = false;
  report.reason = "SERVO_STATUS " + why;
  return report;
}

void TaskManagerNode::on_status(const ServoStatus& message) {
  const ServoReport servo = believed(message);
  const std::int64_t utime = message.frame_utime;
  const std::int64_t now = std::max(stop_devices_.watch(arm_device_).now(), utime);
  const Input input = next_input_.take(servo, stop_devices_.report(now), utime, now);
  const Output output = procedure_->step(input, state_);
  tell(output, utime);
  publish(output, message);
}

void TaskManagerNode::ask_for_stops() {
  for (const DueStop& due : stop_devices_.stops_due()) {
    StopRequest stop = messages::stop_request(due.wish, due.now, bus_->session(), "task-manager");
    stop.request_id = due.request_id;
    out_->stops.publish(stop);
  }
}

void TaskManagerNode::publish(const Output& output, const ServoStatus& status) {
  if (output.goal) {
    ServoGoal goal = servo_goal_message(*output.goal, status);
    out_->servo_goals.publish(goal);
  }
  if (output.drive_goal) {
    BaseGoal goal = base_goal_message(*output.drive_goal, status, out_->base_goals->session());
    out_->base_goals->publish(goal);
  }
  TaskState state = task_state_message(output, status);
  out_->states.publish(state);
}

// The log: every notice and every change, with the task's own time.
void TaskManagerNode::tell(const Output& output, std::int64_t utime) {
  for (const std::string& notice : output.notices) logging::info("{}", notice);
  const std::optional<double> seconds = log_.news(output, utime);
  if (!seconds) return;
  logging::info("{:8.2f} s  {}{}{}{}", *seconds, name_of(output.phase), output.target.empty() ? "" : " ", output.target,
                output.reason.empty() ? "" : ": " + output.reason);
  bus_->set_state(name_of(output.phase), output.reason);
}

}  // namespace markservo::task_manager
