#include "tests/unit/fault_campaign/forged_history.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::campaign {
const std::map<std::string, std::pair<int, std::int64_t>>& forged_stack() {
  static const std::map<std::string, std::pair<int, std::int64_t>> all = {{"simulator", {11, kSimulator}},
                                                                          {"visual-servo", {12, kServo}},
                                                                          {"task-manager", {13, kTask}},
                                                                          {"base-navigator", {14, kNavigator}},
                                                                          {"mark-detector", {15, 105}}};
  return all;
}

Bars forged_bars() {
  Bars bars;
  bars.joint_min = {-1.57, -1.57, -1.57};
  bars.joint_max = {1.57, 1.57, 1.57};
  bars.joint_speed = {5.0, 5.0, 5.0};
  bars.base_speed = 1.2;
  bars.base_turn_rate = 3.0;
  return bars;
}

SimBody held_book(double height) {
  SimBody body{};
  body.name = "red_book";
  body.height_gain = height;
  body.touches_left_finger = body.touches_right_finger = 1;
  return body;
}

ForgedHistory::ForgedHistory() {
  for (const auto& [service, process_and_session] : forged_stack()) {
    process(0.0, 0.1, service, 'S');
    says(0.0, 0.1, service, "ready");
  }
}

template <class M>
ForgedHistory& ForgedHistory::add(double t, const std::string& channel, const M& message, bool foreign) {
  Event event;
  event.t = at(t);
  event.channel = channel;
  event.data.resize(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(event.data.data(), 0, static_cast<int>(event.data.size()));
  event.size = static_cast<std::int64_t>(event.data.size());
  event.foreign = foreign;
  history_.events.push_back(std::move(event));
  return *this;
}

ForgedHistory& ForgedHistory::arm_at(double t, double angle, const SimBody* body, double opening,
                                     const std::string& touched) {
  SimTruth truth{};
  truth.utime = truth.frame_utime = at(t);
  truth.session = truth.frame_session = kSimulator;
  truth.seq = truth.frame_seq = ++seq_;
  truth.valid = 1;
  truth.num_joints = 3;
  truth.shaft = {angle, angle, angle};
  truth.gripper_opening = opening;
  truth.arm_touched = touched.empty() ? 0 : 1;
  truth.touched = touched;
  if (body != nullptr) truth.bodies.push_back(*body);
  truth.num_bodies = static_cast<std::int32_t>(truth.bodies.size());
  return add(t, "SIM_TRUTH", truth);
}

ForgedHistory& ForgedHistory::base_at(double t, double x, bool touched, double heading, double speed) {
  SimBaseTruth truth{};
  truth.utime = at(t);
  truth.session = kSimulator;
  truth.seq = ++seq_;
  truth.pose.x = x;
  truth.pose.heading = heading;
  truth.speed = speed;
  truth.touched = touched ? 1 : 0;
  return add(t, "SIM_BASE_TRUTH", truth);
}

ForgedHistory& ForgedHistory::servo_goals(double from, double to, std::int64_t session, double stamp_off) {
  for (double t = from; t < to; t += 0.2) {
    ServoGoal goal{};
    goal.utime = at(t + stamp_off);
    goal.session = session;
    goal.seq = ++seq_;
    goal.goal_id = 1;
    goal.kind = ServoGoal::POSTURE;
    add(t, "SERVO_GOAL", goal, session == kStranger);
  }
  return *this;
}

ForgedHistory& ForgedHistory::follows(double t, std::int64_t session) {
  ServoStatus status{};
  status.utime = at(t);
  status.session = kServo;
  status.goal_session = session;
  status.goal_id = 1;
  status.state = ServoStatus::POSTURE;
  return add(t, "SERVO_STATUS", status);
}

ForgedHistory& ForgedHistory::base_goals(double from, double to) {
  for (double t = from; t < to; t += 0.2) {
    BaseGoal goal{};
    goal.utime = at(t);
    goal.session = kTask;
    goal.goal_id = 1;
    goal.kind = BaseGoal::DRIVE;
    add(t, "BASE_GOAL", goal);
  }
  return *this;
}

ForgedHistory& ForgedHistory::joint_commands(double from, double to, double position, double speed,
                                             const CommandWriter& writer) {
  for (double t = from; t < to; t += 1.0 / 15.0) {
    JointCommand command{};
    command.utime = command.frame_utime = at(t - writer.age);
    command.session = writer.session;
    command.seq = ++seq_;
    command.frame_session = kSimulator;
    command.frame_seq = seq_;
    command.joint_session = writer.made_for;
    command.gripper_opening = 0.03;
    command.gripper_force = 10.0;
    command.num_joints = 3;
    command.position = {position, position, position};
    command.speed_limit = {speed, speed, speed};
    add(t, "JOINT_COMMAND", command, writer.session == kStranger || writer.foreign);
  }
  return *this;
}

ForgedHistory& ForgedHistory::joint_commands_again(double later) {
  const std::vector<Event> said = history_.events;
  for (Event event : said) {
    if (event.channel != "JOINT_COMMAND") continue;
    event.t += static_cast<std::int64_t>(later * 1e6);
    event.foreign = true;
    history_.events.push_back(std::move(event));
  }
  return *this;
}

ForgedHistory& ForgedHistory::base_commands(double from, double to, double speed, const CommandWriter& writer) {
  for (double t = from; t < to; t += 0.02) {
    BaseCommand command{};
    command.utime = at(t - writer.age);
    command.session = writer.session == kServo ? kNavigator : writer.session;
    command.seq = ++seq_;
    command.odometry_session = writer.made_for;
    command.odometry_seq = seq_;
    command.speed = speed;
    add(t, "BASE_COMMAND", command, writer.session == kStranger || writer.foreign);
  }
  return *this;
}

ForgedHistory& ForgedHistory::stop_state(double t, const std::string& device, bool latched, std::int64_t request) {
  StopState state{};
  state.utime = at(t);
  state.session = kSimulator;
  state.seq = ++seq_;
  state.device = device;
  state.latched = latched ? 1 : 0;
  state.request_session = request == 0 ? 0 : kStranger;
  state.request_id = request;
  return add(t, "STOP_STATE", state);
}

ForgedHistory& ForgedHistory::stop(double t, std::int64_t id) {
  return request(t, StopRequest::STOP, id, t);
}

ForgedHistory& ForgedHistory::reset(double t, std::int64_t id, double stamped) {
  return request(t, StopRequest::RESET, id, stamped);
}

ForgedHistory& ForgedHistory::request(double t, std::int8_t kind, std::int64_t id, double stamped) {
  StopRequest request{};
  request.utime = at(stamped);
  request.session = kStranger;
  request.request_id = id;
  request.kind = kind;
  return add(t, "STOP", request, true);
}

ForgedHistory& ForgedHistory::start_command(double t, std::int64_t id, double stamped) {
  TaskCommand command{};
  command.utime = at(stamped);
  command.session = kStranger;
  command.command_id = id;
  command.kind = TaskCommand::START;
  return add(t, "TASK_COMMAND", command, true);
}

ForgedHistory& ForgedHistory::task_state(double t, int state, const std::string& reason, std::int64_t command) {
  TaskState task{};
  task.utime = at(t);
  task.session = kTask;
  task.seq = ++seq_;
  task.state = static_cast<std::int8_t>(state);
  task.reason = reason;
  task.command_session = command == 0 ? 0 : kStranger;
  task.command_id = command;
  return add(t, "TASK_STATE", task);
}

ForgedHistory& ForgedHistory::says(double from, double to, const std::string& service, const std::string& state,
                                   const std::string& channel, int received) {
  const auto& [pid, session] = forged_stack().at(service);
  for (double t = from; t < to; t += 1.0) {
    ServiceStatus status{};
    status.utime = at(t);
    status.session = session;
    status.seq = ++seq_;
    status.name = service;
    status.pid = pid;
    status.state = state;
    if (!channel.empty()) {
      status.channels.emplace_back();
      status.channels.back().channel = channel;
      status.channels.back().received = 100 + static_cast<std::int64_t>((t - from) * received);
    }
    status.num_channels = static_cast<std::int32_t>(status.channels.size());
    add(t, "SERVICE_STATUS", status);
  }
  return *this;
}

ForgedHistory& ForgedHistory::messages(double from, double to, const std::string& channel, double rate,
                                       std::int64_t size) {
  for (double t = from; t < to; t += 1.0 / rate) {
    Event event;
    event.t = at(t);
    event.channel = channel;
    event.size = size;
    history_.events.push_back(event);
  }
  return *this;
}

History ForgedHistory::history() const {
  History sorted = history_;
  std::stable_sort(sorted.events.begin(), sorted.events.end(),
                   [](const Event& a, const Event& b) { return a.t < b.t; });
  return sorted;
}

}  // namespace markservo::campaign
