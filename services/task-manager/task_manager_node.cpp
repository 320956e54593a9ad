#include "services/task-manager/task_manager_node.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <stdexcept>

#include "common/bus/message_traits.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/time/clocks.hpp"
#include "services/task-manager/options.hpp"

namespace markservo::task_manager {
namespace {

static_assert(static_cast<int>(Phase::kLook) == 1 && static_cast<int>(Phase::kStopped) == TaskState::STOPPED &&
                  static_cast<int>(Phase::kDrive) == TaskState::DRIVE,
              "phases as TaskState.lcm numbers them");
static_assert(static_cast<int>(BaseState::kStopped) == BaseStatus::STOPPED, "as BaseStatus.lcm numbers them");
static_assert(static_cast<int>(ServoState::kStopped) == 7, "as ServoStatus.lcm numbers them");
static_assert(static_cast<int>(Sight::kInconsistent) == 5, "as LocatedMark.lcm numbers them");

constexpr std::int64_t kSilence_us = 1'000'000;  // of a stop device: five repeats of STOP_STATE are missing

Eigen::Vector3d vector(const Vector3& v) {
  return {v.x, v.y, v.z};
}

template <class Enum>
Enum checked(int value, Enum last, const char* what) {
  if (value < 0 || value > static_cast<int>(last)) {
    throw std::invalid_argument(std::string(what) + " is " + std::to_string(value) + "; allowed: 0 to " +
                                std::to_string(static_cast<int>(last)));
  }
  return static_cast<Enum>(value);
}

}  // namespace

void TaskManagerNode::add_options(CLI::App& app) {
  add_parameter_options(app, parameters_);
}

void TaskManagerNode::configure(const std::string& robot_file) {
  robot_ = robot::load_robot_description(robot_file);
  if (parameters_.carry.place_radius_max < parameters_.carry.place_radius_min) {
    throw ConfigurationError("place-radius-max is " + std::to_string(parameters_.carry.place_radius_max) +
                             " m; allowed: at least place-radius-min, " +
                             std::to_string(parameters_.carry.place_radius_min) + " m");
  }
  procedure_.emplace(robot_, parameters_);
}

void TaskManagerNode::start(bus::Bus& bus) {
  bus_ = &bus;
  goals_.emplace(bus.advertise(channels::kServoGoal));
  states_.emplace(bus.advertise(channels::kTaskState));
  if (robot_.base) {
    base_goals_.emplace(bus.advertise(channels::kBaseGoal));
    bus.on_each(channels::kBaseStatus, [this](const BaseStatus& status) { on_base(status); });
  }
  bus.on_each(channels::kTaskCommand, [this](const TaskCommand& command) { on_command(command); });
  bus.on_each(channels::kStopState, [this](const StopState& stop) { on_stop(stop); });
  bus.on_each(channels::kJointState, [this](const JointState& joints) { on_joints(joints); });
  bus.on_each(channels::kTargetPose, [this](const TargetPose& pose) { on_pose(pose); });
  bus.on_each(channels::kServoStatus, [this](const ServoStatus& status) { on_status(status); });
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
  commands_.add(command, steady_clock_us());
}

void TaskManagerNode::on_pose(const TargetPose& pose) {
  std::vector<MarkReport> marks;
  for (const LocatedMark& mark : pose.marks) {
    marks.push_back({mark.name, checked(mark.status, Sight::kInconsistent, "a mark's status"), vector(mark.p_C)});
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
  input_.arm = arm;
}

void TaskManagerNode::on_stop(const StopState& stop) {
  const auto& devices = robot_.stop_devices;
  if (std::find(devices.begin(), devices.end(), stop.device) == devices.end()) return;
  stops_[stop.device] = stop;
  if (stop.latched != 0) stopped_meanwhile_ = true;
}

StopReport TaskManagerNode::stop_report() const {
  StopReport report;
  report.known = true;
  report.meanwhile = stopped_meanwhile_;
  for (const std::string& device : robot_.stop_devices) {
    const auto found = stops_.find(device);
    if (found == stops_.end() || input_.utime - found->second.utime > kSilence_us) {
      report.known = false;
      report.silent += (report.silent.empty() ? "" : ", ") + device;
    }
    if (found != stops_.end() && found->second.latched != 0) {
      report.latched = true;
      report.reason += (report.reason.empty() ? "" : "; ") + device + ": " + found->second.reason;
    }
  }
  return report;
}

void TaskManagerNode::on_base(const BaseStatus& status) {
  BaseReport report;
  report.utime = status.utime;
  report.goal_id = status.goal_session == base_goals_->session() ? status.goal_id : 0;
  report.state = checked(status.state, BaseState::kStopped, "BASE_STATUS.state");
  report.reason = status.reason;
  base_reports_.add(report);
}

void TaskManagerNode::on_status(const ServoStatus& status) {
  input_.utime = status.frame_utime;
  input_.servo.goal_id = status.goal_session == goals_->session() ? status.goal_id : 0;
  input_.servo.state = checked(status.state, ServoState::kStopped, "SERVO_STATUS.state");
  input_.servo.settled = status.settled != 0;
  input_.servo.reason = status.reason;
  input_.base = base_reports_.before(input_.utime);
  input_.stop = stop_report();
  stopped_meanwhile_ = false;
  input_.commands = commands_.take(steady_clock_us(), !bus_->replaying());
  const Output output = procedure_->step(input_, state_);
  tell(output, input_.utime);

  if (output.goal) send(*output.goal, status);
  if (output.drive_goal) send(*output.drive_goal, status);
  TaskState message;
  bus::answer_frame(message, status);
  message.command_session = output.command_session;
  message.command_id = output.command_id;
  message.state = static_cast<int8_t>(output.phase);
  message.attempt = output.attempt;
  message.result = static_cast<int8_t>(output.result);
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
