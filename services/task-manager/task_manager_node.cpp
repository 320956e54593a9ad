#include "services/task-manager/task_manager_node.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "common/messages/message_traits.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/messages/state_codes.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/stop_device.hpp"
#include "services/task-manager/options.hpp"

namespace markservo::task_manager {
namespace {

using messages::drop;
using messages::stamp_of;

constexpr std::int64_t kSilence_us = 1'000'000;  // of a stop device: five repeats of STOP_STATE are missing

Eigen::Vector3d vector(const Vector3& v) {
  return {v.x, v.y, v.z};
}

}  // namespace

void TaskManagerNode::add_options(CLI::App& app) {
  app.add_option("--arm-device", arm_device_, "The arm's name in STOP_STATE")->capture_default_str();
  app.add_option("--base-device", base_device_, "The base's name in STOP_STATE")->capture_default_str();
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
  procedure_.emplace(robot_, parameters_);
}

void TaskManagerNode::start(bus::Bus& bus) {
  bus_ = &bus;
  goals_.emplace(bus.advertise(channels::kServoGoal));
  states_.emplace(bus.advertise(channels::kTaskState));
  stop_requests_.emplace(bus.advertise(channels::kStop));
  if (robot_.base) {
    base_goals_.emplace(bus.advertise(channels::kBaseGoal));
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
  Command command;
  command.session = message.session;
  command.id = message.command_id;
  command.kind = message.kind == TaskCommand::START  ? CommandKind::kStart
                 : message.kind == TaskCommand::HOME ? CommandKind::kHome
                                                     : CommandKind::kAbort;
  command.target = message.target;
  command.carry = message.carry != 0;
  if (message.expected_known != 0) command.p_CT_expected = vector(message.p_CT_expected);
  if (message.drive != 0) command.drive_pose = {message.drive_pose.x, message.drive_pose.y, message.drive_pose.heading};
  command.utime = message.utime;
  const motion::CommandStamp stamp{command.session, command.id, command.utime};
  const std::int64_t now = watch(arm_device_).now();
  if (now != 0 && command.kind != CommandKind::kAbort) drop(state_.inbox.why_stale(stamp, now));
  commands_.add(command);
}

motion::MoverWatch& TaskManagerNode::watch(const std::string& device) {
  return movers_.try_emplace(device, device).first->second;
}

void TaskManagerNode::on_pose(const TargetPose& pose) {
  const motion::Heard heard = watch(arm_device_).hear_stream(channels::kTargetPose.name, stamp_of(pose));
  ask_for_stops();
  drop(motion::why_dropped(heard));
  std::vector<MarkReport> marks;
  for (const LocatedMark& mark : pose.marks) {
    marks.push_back({mark.name, messages::state_of<MarkStatus>(mark.status), vector(mark.p_C)});
  }
  input_.pose_utime = pose.utime;
  input_.marks = std::move(marks);
}

void TaskManagerNode::on_joints(const JointState& joints) {
  if (joints.num_joints != robot::kNumJoints) {
    throw std::invalid_argument("JOINT_STATE has " + std::to_string(joints.num_joints) + " joints; allowed: " +
                                std::to_string(robot::kNumJoints) + ", as the robot's description");
  }
  ArmReport arm;
  arm.session = joints.session;
  for (int i = 0; i < robot::kNumJoints; ++i) arm.q[i] = joints.position[static_cast<std::size_t>(i)];
  arm.gripper_opening = joints.gripper_opening;
  const motion::Word word = watch(arm_device_).hear_report(channels::kJointState.name, stamp_of(joints));
  ask_for_stops();
  if (word == motion::Word::kForeign) strangers_ = arm;
  drop(motion::why_dropped(word));
  input_.arm = arm;
}

void TaskManagerNode::on_stop(const StopState& stop) {
  const auto& devices = robot_.stop_devices;
  if (std::find(devices.begin(), devices.end(), stop.device) == devices.end()) return;
  const motion::Word word = watch(stop.device).hear_stop_state(stamp_of(stop), stop.latched != 0, stop.reason);
  ask_for_stops();
  if (word == motion::Word::kReplaced && stop.device == arm_device_) {
    const bool heard = strangers_ && strangers_->session == stop.session;
    if (heard) input_.arm = strangers_;
    // What another said before anyone was known tells nothing of what the hand holds.
    if (!heard && state_.goal.id == 0) input_.arm.reset();
  }
  drop(motion::why_dropped(word));
  stop_state_utimes_[stop.device] = stop.utime;
  if (stop.latched != 0) stopped_meanwhile_ = true;
}

StopReport TaskManagerNode::stop_report() const {
  StopReport report;
  report.known = true;
  report.meanwhile = stopped_meanwhile_;
  const auto latched = [&report](const std::string& device, const std::string& why) {
    report.latched = true;
    report.reason += (report.reason.empty() ? "" : "; ") + device + ": " + why;
  };
  for (const std::string& device : robot_.stop_devices) {
    const auto told = stop_state_utimes_.find(device);
    if (told == stop_state_utimes_.end() || std::abs(input_.now - told->second) > kSilence_us) {
      report.known = false;
      report.silent += (report.silent.empty() ? "" : ", ") + device;
    }
    const auto found = movers_.find(device);
    if (found == movers_.end()) continue;
    const motion::MoverWatch& mover = found->second;
    if (!mover.blocked().empty()) {
      latched(device, mover.blocked());
    } else if (mover.latched().value_or(false)) {
      latched(device, mover.stop_reason());
    }
  }
  return report;
}

// Where two claim to be one, nothing may move until somebody has looked.
void TaskManagerNode::ask_for_stops() {
  for (auto& [device, mover] : movers_) {
    if (const auto wish = mover.stop_due()) {
      StopRequest stop = messages::stop_request(*wish, mover.now(), bus_->session(), "task-manager");
      // One id for the repetitions of one wish, whichever mover it is for.
      if (asked_ != std::make_pair(device, wish->id)) ++stop_request_id_;
      asked_ = {device, wish->id};
      stop.request_id = stop_request_id_;
      stop_requests_->publish(stop);
    }
  }
}

void TaskManagerNode::on_base(const BaseStatus& status) {
  const motion::Heard heard = watch(base_device_).hear_stream(channels::kBaseStatus.name, stamp_of(status));
  ask_for_stops();
  drop(motion::why_dropped(heard));
  BaseReport report;
  report.utime = status.utime;
  report.goal_id = status.goal_session == base_goals_->session() ? status.goal_id : 0;
  report.state = messages::state_of<BaseState>(status.state);
  report.reason = status.reason;
  report.follows_another = status.goal_session != 0 && report.goal_id == 0 && report.state != BaseState::kStale;
  base_reports_.add(report);
}

// A second visual-servo's word is answered, so that who waits for the answer goes on, but not believed.
ServoReport TaskManagerNode::servo_report(const ServoStatus& status) {
  const motion::Heard heard = watch(arm_device_).hear_stream(channels::kServoStatus.name, stamp_of(status));
  ask_for_stops();
  const std::string why = motion::why_dropped(heard);
  if (heard == motion::Heard::kLate) drop(why);
  ServoReport report;
  report.goal_id = status.goal_session == goals_->session() ? status.goal_id : 0;
  report.state = messages::state_of<ServoState>(status.state);
  report.settled = status.settled != 0;
  report.reason = status.reason;
  report.follows_another = status.goal_session != 0 && report.goal_id == 0 && report.state != ServoState::kStale;
  if (why.empty()) return report;
  report.state = ServoState::kStale;
  report.settled = false;
  report.reason = "SERVO_STATUS " + why;
  return report;
}

void TaskManagerNode::on_status(const ServoStatus& status) {
  input_.servo = servo_report(status);
  input_.utime = status.frame_utime;
  input_.now = std::max(watch(arm_device_).now(), status.frame_utime);
  input_.base = base_reports_.before(input_.utime);
  input_.stop = stop_report();
  stopped_meanwhile_ = false;
  input_.commands = commands_.take();
  const Output output = procedure_->step(input_, state_);
  tell(output, input_.utime);

  if (output.goal) send(*output.goal, status);
  if (output.drive_goal) send(*output.drive_goal, status);
  TaskState message;
  messages::answer_frame(message, status);
  message.command_session = output.command_session;
  message.command_id = output.command_id;
  message.state = messages::code_of(output.phase);
  message.attempt = output.attempt;
  message.result = messages::code_of(output.result);
  message.target = output.target;
  message.reason = output.reason;
  states_->publish(message);
}

void TaskManagerNode::send(const Goal& goal, const ServoStatus& status) {
  ServoGoal message;
  message.utime = status.frame_utime;
  message.goal_id = goal.id;
  message.kind = static_cast<int8_t>(goal.kind);
  message.target = goal.target;
  message.p_TG_C.x = goal.p_TG.x();
  message.p_TG_C.y = goal.p_TG.y();
  message.p_TG_C.z = goal.p_TG.z();
  message.tolerance = goal.tolerance;
  message.speed = goal.speed;
  message.num_joints = 0;
  if (goal.kind == GoalKind::kPosture) {
    message.num_joints = robot::kNumJoints;
    message.position.assign(goal.q.data(), goal.q.data() + robot::kNumJoints);
  }
  message.gripper_opening = goal.opening;
  message.gripper_force = goal.force;
  goals_->publish(message);
}

void TaskManagerNode::send(const DriveGoal& goal, const ServoStatus& status) {
  BaseGoal message{};
  message.utime = status.frame_utime;
  message.session = base_goals_->session();
  message.goal_id = goal.id;
  message.kind = goal.drive ? BaseGoal::DRIVE : BaseGoal::HOLD;
  message.frame = goal.from_robot ? BaseGoal::ROBOT : BaseGoal::WORLD;
  message.pose.x = goal.pose.x;
  message.pose.y = goal.pose.y;
  message.pose.heading = goal.pose.heading;
  message.clearance = goal.clearance;
  message.speed = goal.speed;
  base_goals_->publish(message);
}

// The log: every notice and every change, with the task's own time.
void TaskManagerNode::tell(const Output& output, std::int64_t utime) {
  for (const std::string& notice : output.notices) spdlog::info("{}", notice);
  const bool changed = !told_ || told_->phase != output.phase || told_->reason != output.reason ||
                       told_->command_id != output.command_id || told_->command_session != output.command_session;
  if (!changed) return;
  const bool begins = under_way(output.phase) && (!told_ || !under_way(told_->phase));
  if (begins) task_began_ = utime;
  const double seconds = task_began_ == 0 ? 0.0 : seconds_between(task_began_, utime);
  spdlog::info("{:8.2f} s  {}{}{}{}", seconds, name_of(output.phase), output.target.empty() ? "" : " ", output.target,
               output.reason.empty() ? "" : ": " + output.reason);
  bus_->set_state(name_of(output.phase), output.reason);
  told_ = output;
}

}  // namespace markservo::task_manager
