#include "services/task-manager/guards.hpp"

#include "services/task-manager/plans/approach_plan.hpp"
#include "services/task-manager/plans/drive_field.hpp"

namespace markservo::task_manager {
namespace {

std::string names_of_targets(const robot::RobotDescription& robot) {
  std::string names;
  for (const robot::MarkDescription& mark : robot.marks) {
    if (mark.role == robot::MarkRole::kTarget) names += (names.empty() ? "" : ", ") + mark.name;
  }
  return names;
}

// Why the robot, as it is described, cannot do it.
std::string why_not_able(const Command& command, const robot::RobotDescription& robot,
                         const DriveParameters& parameters) {
  if (!robot.arm) return "the robot has no arm: its description has no section 'arm'";
  if (command.drive_pose) {
    if (!robot.base) return "the robot cannot drive: its description has no section 'base'";
    if (auto why = why_off_the_field(robot, parameters.tag_field, *command.drive_pose); !why.empty()) return why;
  }
  if (command.kind == CommandKind::kDrive) return "";
  if (hand_mark_of(robot) == nullptr) return "the robot's description has no mark of role manipulator";
  const robot::MarkDescription* mark = robot.find_mark(command.target);
  if (mark == nullptr || mark->role != robot::MarkRole::kTarget) {
    return "unknown target '" + command.target + "'; the robot's description has: " + names_of_targets(robot);
  }
  if (!mark->grip) return "the description of " + command.target + " has no section 'grip': it cannot be taken";
  return "";
}

}  // namespace

std::string why_no_task(const Command& command, const PhaseContext& context) {
  if (auto why = why_not_able(command, context.robot, context.parameters.drive); !why.empty()) return why;
  if (context.input.stop.latched) return describe_latched(context.input.stop);
  if (context.holding.something()) {
    return "the hand holds " + context.task.command.target + ": task home puts it back";
  }
  return "";
}

std::string why_not_home(const PhaseContext& context) {
  const StopReport& stop = context.input.stop;
  if (!context.robot.arm) return "home: the robot has no arm";
  if (stop.latched) return describe_latched(stop);
  if (!stop.known) return "home: not every stop device answers: no STOP_STATE of " + stop.silent;
  if (!context.input.arm) return "home: the arm does not answer (no JOINT_STATE)";
  if (context.holding.something() && !context.holding.over_place()) {
    return "home: the hand holds " + context.task.command.target +
           " away from its place; take it out of the hand first";
  }
  return "";
}

std::string who_is_silent(const Input& input) {
  if (!input.arm) return "the arm does not answer: no JOINT_STATE";
  return "not every stop device answers: no STOP_STATE of " + input.stop.silent;
}

}  // namespace markservo::task_manager
