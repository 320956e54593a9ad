#include "services/task-manager/phases/endings.hpp"

namespace markservo::task_manager {

Transition look_for_target(const PhaseContext& context) {
  return {Look(), "looking for the mark of " + context.task.command.target};
}

Transition refused(const std::string& reason) {
  return {Refused(), reason};
}

Transition failed(const std::string& reason) {
  return {Failed(), reason};
}

Transition stopped(const std::string& reason) {
  return {Stopped(), reason};
}

Transition transition_to(const Ending& ending) {
  switch (ending.phase) {
    case Phase::kRefused:
      return refused(ending.reason);
    case Phase::kFailed:
      return failed(ending.reason);
    default:
      return stopped(ending.reason);
  }
}

std::optional<Transition> not_done(const MoveReport& report) {
  if (report.state != MoveState::kFailed) return std::nullopt;
  return failed(report.reason);
}

Transition not_taken(const PhaseContext& context, const std::string& reason) {
  const Task& task = context.task;
  if (task.attempt > 1) return failed(task.failure + "; and then: " + reason);
  if (task.driven) return failed("after the drive: " + reason);
  return refused(reason);
}

}  // namespace markservo::task_manager
