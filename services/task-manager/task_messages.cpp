#include "services/task-manager/task_messages.hpp"

#include <cstddef>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <stdexcept>
#include <string>

#include "common/messages/message_traits.hpp"
#include "common/messages/state_codes.hpp"

namespace markservo::task_manager {
namespace {

Eigen::Vector3d vector_of(const Vector3& v) {
  return {v.x, v.y, v.z};
}

CommandKind kind_of(std::int8_t kind) {
  switch (kind) {
    case TaskCommand::START:
      return CommandKind::kStart;
    case TaskCommand::HOME:
      return CommandKind::kHome;
    case TaskCommand::DRIVE:
      return CommandKind::kDrive;
    default:
      return CommandKind::kAbort;
  }
}

}  // namespace

Command command_of(const TaskCommand& message) {
  Command command;
  command.session = message.session;
  command.id = message.command_id;
  command.utime = message.utime;
  command.kind = kind_of(message.kind);
  command.target = message.target;
  command.carry = message.carry != 0;
  if (message.expected_known != 0) command.p_CT_expected = vector_of(message.p_CT_expected);
  const bool drives = command.kind == CommandKind::kDrive || message.drive != 0;
  if (drives) command.drive_pose = {message.drive_pose.x, message.drive_pose.y, message.drive_pose.heading};
  return command;
}

std::vector<MarkReport> mark_reports(const TargetPose& message) {
  std::vector<MarkReport> marks;
  for (const LocatedMark& mark : message.marks) {
    marks.push_back({mark.name, messages::state_of<MarkStatus>(mark.status), vector_of(mark.p_C)});
  }
  return marks;
}

ArmReport arm_report(const JointState& message) {
  if (message.num_joints != robot::kNumJoints) {
    throw std::invalid_argument("JOINT_STATE has " + std::to_string(message.num_joints) + " joints; allowed: " +
                                std::to_string(robot::kNumJoints) + ", as the robot's description");
  }
  ArmReport report;
  report.session = message.session;
  for (int i = 0; i < robot::kNumJoints; ++i) report.q[i] = message.position[static_cast<std::size_t>(i)];
  report.gripper_opening = message.gripper_opening;
  return report;
}

BaseReport base_report(const BaseStatus& message, std::int64_t goal_session) {
  BaseReport report;
  report.utime = message.utime;
  report.goal_id = message.goal_session == goal_session ? message.goal_id : 0;
  report.state = messages::state_of<BaseState>(message.state);
  report.reason = message.reason;
  report.follows_another = message.goal_session != 0 && report.goal_id == 0 && report.state != BaseState::kStale;
  return report;
}

ServoReport servo_report(const ServoStatus& message, std::int64_t goal_session) {
  ServoReport report;
  report.goal_id = message.goal_session == goal_session ? message.goal_id : 0;
  report.state = messages::state_of<ServoState>(message.state);
  report.settled = message.settled != 0;
  report.reason = message.reason;
  report.follows_another = message.goal_session != 0 && report.goal_id == 0 && report.state != ServoState::kStale;
  return report;
}

ServoGoal servo_goal_message(const Goal& goal, const ServoStatus& status) {
  ServoGoal message{};
  message.utime = status.frame_utime;
  message.goal_id = goal.id;
  message.kind = static_cast<std::int8_t>(goal.kind);
  message.target = goal.target;
  message.p_TG_C.x = goal.p_TG.x();
  message.p_TG_C.y = goal.p_TG.y();
  message.p_TG_C.z = goal.p_TG.z();
  message.tolerance = goal.tolerance;
  message.speed = goal.speed;
  if (goal.kind == GoalKind::kPosture) {
    message.num_joints = robot::kNumJoints;
    message.position.assign(goal.q.data(), goal.q.data() + robot::kNumJoints);
  }
  message.gripper_opening = goal.opening;
  message.gripper_force = goal.force;
  return message;
}

BaseGoal base_goal_message(const DriveGoal& goal, const ServoStatus& status, std::int64_t session) {
  BaseGoal message{};
  message.utime = status.frame_utime;
  message.session = session;
  message.goal_id = goal.id;
  message.kind = goal.drive ? BaseGoal::DRIVE : BaseGoal::HOLD;
  message.frame = goal.from_robot ? BaseGoal::ROBOT : BaseGoal::WORLD;
  message.pose.x = goal.pose.x;
  message.pose.y = goal.pose.y;
  message.pose.heading = goal.pose.heading;
  message.clearance = goal.clearance;
  message.speed = goal.speed;
  return message;
}

TaskState task_state_message(const Output& output, const ServoStatus& status) {
  TaskState message{};
  messages::answer_frame(message, status);
  message.command_session = output.command_session;
  message.command_id = output.command_id;
  message.state = messages::code_of(output.phase);
  message.attempt = output.attempt;
  message.result = messages::code_of(output.result);
  message.target = output.target;
  message.reason = output.reason;
  return message;
}

}  // namespace markservo::task_manager
