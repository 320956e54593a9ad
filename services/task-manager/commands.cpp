#include "services/task-manager/commands.hpp"

#include <string>

#include "services/task-manager/guards.hpp"
#include "services/task-manager/phases/endings.hpp"
#include "services/task-manager/plans/approach_plan.hpp"
#include "services/task-manager/plans/lift_plan.hpp"

namespace markservo::task_manager {
namespace {

const char* word_of(CommandKind kind) {
  switch (kind) {
    case CommandKind::kStart:
      return "START";
    case CommandKind::kHome:
      return "HOME";
    case CommandKind::kAbort:
      return "ABORT";
    case CommandKind::kDrive:
      return "DRIVE";
  }
  return "";
}

std::string words_of(const Command& command) {
  const std::string word = word_of(command.kind);
  return command.kind == CommandKind::kStart ? word + " of '" + command.target + "'" : word;
}

// START or DRIVE.
std::optional<Transition> begin_task(const Command& command, Phase phase, PhaseContext& context) {
  Task& task = context.task;
  if (under_way(phase)) {
    context.notices.push_back(words_of(command) + " ignored: " + subject_of(task.command) + " is under way (" +
                              name_of(phase) + "); abort it first");
    return std::nullopt;
  }
  const std::string why = why_no_task(command, context);
  if (context.holding.something() && !why.empty()) {
    context.notices.push_back(words_of(command) + " refused: " + why);
    return refused(why);
  }
  task = Task();
  task.command = command;
  task.attempt = command.kind == CommandKind::kStart ? 1 : 0;
  if (!why.empty()) return refused(why);
  if (command.drive_pose) return Transition{Drive::to(*command.drive_pose), "making ready to drive"};
  return look_for_target(context);
}

Transition put_back_and_go_home(const PhaseContext& context) {
  const Task& task = context.task;
  const PosturePath path =
      plan_put_back(context.arm(), context.parameters, context.input.arm->q,
                    robot::grip_point(context.arm(), task.at_grip.q), task.place.p_CG_first, context.closed());
  if (!path.reachable()) return failed("cannot put it back: " + path.trouble());
  return {Release(path.moves(), Release::Then::kGoHome), "putting " + task.command.target + " back"};
}

std::optional<Transition> home(Phase phase, PhaseContext& context) {
  if (under_way(phase)) {
    context.notices.push_back(std::string("HOME ignored: a task is under way (") + name_of(phase) +
                              "); abort it first");
    return std::nullopt;
  }
  if (auto why = why_not_home(context); !why.empty()) return stopped(why);
  if (context.holding.something()) return put_back_and_go_home(context);
  const ArmReport& arm = *context.input.arm;
  const PosturePath path = plan_home(context.arm(), context.parameters, {arm.q, arm.gripper_opening});
  if (!path.reachable()) return failed("no way home: " + path.trouble());
  return Transition{GoHome(path.moves(), false), "on the way home"};
}

std::optional<Transition> abort_task(Phase phase, PhaseContext& context) {
  if (under_way(phase)) return stopped("aborted by operator");
  context.notices.emplace_back("nothing to abort");
  return std::nullopt;
}

std::optional<Transition> execute(const Command& command, Phase phase, PhaseContext& context) {
  switch (command.kind) {
    case CommandKind::kStart:
    case CommandKind::kDrive:
      return begin_task(command, phase, context);
    case CommandKind::kHome:
      return home(phase, context);
    case CommandKind::kAbort:
      return abort_task(phase, context);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Transition> hear(const Command& command, Phase phase, motion::CommandInbox& inbox,
                               PhaseContext& context) {
  const motion::CommandStamp stamp{command.session, command.id, command.utime};
  const std::int64_t now = context.input.now;
  switch (inbox.hear(stamp, now, command.kind == CommandKind::kAbort)) {
    case motion::CommandHeard::kExecute:
      return execute(command, phase, context);
    case motion::CommandHeard::kStale:
      context.notices.push_back(std::string(word_of(command.kind)) + " refused: " + inbox.why_stale(stamp, now));
      break;
    case motion::CommandHeard::kAgain:
      // A sender that counts badly is to be obeyed all the same.
      if (command.kind == CommandKind::kAbort && under_way(phase)) return execute(command, phase, context);
      break;
  }
  return std::nullopt;
}

}  // namespace markservo::task_manager
