#include "services/task-operator/task_operator_node.hpp"

#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <markservo/ServiceStatus.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>

#include "common/bus/options.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/messages/operator_messages.hpp"
#include "common/motion/mover_watch.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/robot_description.hpp"
#include "common/text/text.hpp"
#include "common/time/clocks.hpp"
#include "services/task-operator/asked_bus.hpp"

namespace markservo::task_operator {
namespace {

constexpr std::int64_t kRequest = 1;        // the only one of this program's session
constexpr std::size_t kMostServices = 100;  // remembered, whoever invents names

task::Action action_of(const std::string& text) {
  static const std::map<std::string, task::Action> actions{
      {"start", task::Action::kStart}, {"abort", task::Action::kAbort}, {"home", task::Action::kHome},
      {"drive", task::Action::kDrive}, {"stop", task::Action::kStop},   {"reset", task::Action::kReset}};
  return actions.at(text);
}

// `what` is the option that has the place: x and y in m, heading in degrees.
void check_place(const std::string& what, const std::vector<double>& place, const robot::RobotDescription& robot,
                 const std::string& robot_file) {
  if (!robot.base) throw ConfigurationError(what + ": " + robot_file + " has no section 'base'; allowed: with one");
  for (const double value : place) {
    if (!std::isfinite(value)) throw ConfigurationError(what + ": not a number; allowed: X,Y,HEADING_DEG");
  }
}

std::string targets_of(const robot::RobotDescription& robot) {
  std::string names;
  for (const auto& mark : robot.marks) {
    if (mark.role == robot::MarkRole::kTarget) names += (names.empty() ? "" : ", ") + mark.name;
  }
  return names;
}

}  // namespace

TaskOperatorNode::TaskOperatorNode(const std::string& program) : typed_(program) {
  parameters_.command = typed_.of("task");
}

void TaskOperatorNode::add_options(CLI::App& app) {
  const bus::Options add(app);
  add.option("ACTION", wish_.action_text,
             "start: take --target, and tell how it goes; abort: hold where the arm is; home: back to the home "
             "posture; drive: to PLACE; stop: nothing moves until reset; reset: release the stop, and move nothing")
      .required()
      .not_in_config()
      .one_of({"start", "abort", "home", "drive", "stop", "reset"});
  add.option("PLACE", wish_.place, "drive: X,Y,HEADING_DEG, where to (m and degrees on the tag field)")
      .not_in_config()
      .delimiter(',')
      .expected(3);
  add.option("--target", wish_.target, "start: whose mark to take");
  add.option("--drive", wish_.drive, "start: X,Y,HEADING_DEG: drive there first (m and degrees on the tag field)")
      .delimiter(',')
      .expected(3);
  add.flag("--carry", wish_.carry, "start: carry the object to the side, release it there and go home");
  add.option("--source", wish_.source, "stop, reset: who asks, for the logs").show_default();
  add.option("--patience", parameters_.patience, "How long to wait for an answer, s")
      .within(0.1, 3600.0)
      .show_default();
  add.footer(
      "Exit codes: 0 lifted, done, stopped or released; 1 refused, failed or stopped, and why; 2 bad "
      "configuration; 3 no bus; 4 no answer, and from whom.");
}

void TaskOperatorNode::configure(const std::string& robot_file) {
  wish_.action = action_of(wish_.action_text);
  const robot::RobotDescription robot = robot::load_robot_description(robot_file);
  if (robot.stop_devices.empty()) {
    throw ConfigurationError(robot_file + ": stop_devices is empty; allowed: what moves, so that it can be stopped");
  }
  if (wish_.action == task::Action::kStart) {
    const robot::MarkDescription* mark = robot.find_mark(wish_.target);
    if (mark == nullptr || mark->role != robot::MarkRole::kTarget) {
      throw ConfigurationError("--target is '" + wish_.target + "'; allowed: " + targets_of(robot) + " (" + robot_file +
                               ")");
    }
    if (!wish_.drive.empty()) check_place("--drive", wish_.drive, robot, robot_file);
  } else if (!wish_.target.empty() || wish_.carry || !wish_.drive.empty()) {
    throw ConfigurationError("--target, --drive or --carry: without start; allowed: with start");
  }
  if ((wish_.action == task::Action::kDrive) != !wish_.place.empty()) {
    throw ConfigurationError("X,Y,HEADING_DEG behind " + wish_.action_text + "; allowed: behind drive, always");
  }
  if (!wish_.place.empty()) check_place("drive", wish_.place, robot, robot_file);
  dialogue_.emplace(wish_.action, robot.stop_devices, parameters_);
  sender_.emplace(robot.stop_devices);
}

void TaskOperatorNode::start(bus::Bus& bus) {
  bus_ = &bus;
  stops_.emplace(bus.advertise(channels::kStop));
  commands_.emplace(bus.advertise(channels::kTaskCommand));
  bus.on_each(channels::kStopState, [this](const StopState& state) { on_stop_state(state); });
  bus.on_each(channels::kTaskState, [this](const TaskState& state) { on_task_state(state); });
  bus.on_each(channels::kServiceStatus, [this](const ServiceStatus& status) {
    if (status.session != bus_->session() && services_.size() < kMostServices) services_.insert(status.name);
  });
}

void TaskOperatorNode::on_stop_state(const StopState& state) {
  sender_->observe_stop_state(state.device, state.utime);
  task::StopReport report;
  report.device = state.device;
  report.latched = state.latched != 0;
  report.answers_us = state.request_session == bus_->session() && state.request_id == kRequest;
  report.reason = state.reason;
  dialogue_->observe(report);
}

void TaskOperatorNode::on_task_state(const TaskState& state) {
  const motion::StreamHeard heard = task_.hear(messages::stamp_of(state), 0);
  if (heard == motion::StreamHeard::kSecond) dialogue_->observe_conflict(task_.words());
  messages::drop(motion::why_dropped(heard));
  sender_->observe_task_state(state.utime);
  const bool is_ours = state.command_session == bus_->session() && state.command_id == kRequest;
  dialogue_->observe(messages::task_report(state, is_ours), steady_seconds());
}

void TaskOperatorNode::send() {
  const auto utime = sender_->stamp(messages::command_kind(wish_.action));
  if (!utime) return;  // it would be refused; who has not spoken is told when patience ends
  if (wish_.action == task::Action::kStop || wish_.action == task::Action::kReset) {
    StopRequest request{};
    request.utime = *utime;
    request.session = bus_->session();
    request.request_id = kRequest;
    request.kind = wish_.action == task::Action::kStop ? StopRequest::STOP : StopRequest::RESET;
    request.source = wish_.source;
    request.reason = "asked by an operator";
    stops_->publish(request);
    return;
  }
  TaskCommand command{};
  command.utime = *utime;
  command.session = bus_->session();
  command.command_id = kRequest;
  command.kind = messages::task_command_kind(wish_.action);
  command.target = wish_.target;
  command.carry = wish_.carry ? 1 : 0;
  command.drive = wish_.drive.empty() ? 0 : 1;
  const std::vector<double>& place = wish_.drive.empty() ? wish_.place : wish_.drive;
  if (!place.empty()) command.drive_pose = {place[0], place[1], geometry::radians(place[2])};
  commands_->publish(command);
}

void TaskOperatorNode::tell(const task::Ending& ending) const {
  std::string line = ending.line;
  if (ending.exit_code == task::kExitNoAnswer) line += "; " + told_of_bus(bus_->urls().out, services_);
  if (ending.exit_code != task::kExitReached) std::cerr << typed_.name_or("task-operator") << ": ";
  (ending.exit_code == task::kExitReached ? std::cout : std::cerr) << text::printable(line) << std::endl;
}

void TaskOperatorNode::run(bus::Bus& bus) {
  do {
    const task::Step step = dialogue_->step(steady_seconds());
    if (step.send) send();
    for (const std::string& line : step.lines) std::cout << text::printable(line) << std::endl;
    if (!step.ending) continue;
    exit_code_ = step.ending->exit_code;
    tell(*step.ending);
    return;
  } while (bus.poll(std::chrono::milliseconds(50)));
  exit_code_ = task::kExitInterrupted;
  const std::int8_t kind = messages::task_command_kind(wish_.action);
  const bool lasts = kind != TaskCommand::ABORT;
  std::cerr << typed_.name_or("task-operator") << ": ended before the answer; "
            << (lasts ? "the task goes on: abort or stop ends it" : "what was asked may have been done") << std::endl;
}

}  // namespace markservo::task_operator
