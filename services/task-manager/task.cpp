#include "services/task-manager/task.hpp"

namespace markservo::task_manager {

std::string subject_of(const Command& command) {
  return command.kind == CommandKind::kDrive ? "a drive" : command.target;
}

Result result_after(Phase left, Phase entered, Result so_far) {
  switch (entered) {
    case Phase::kHoldLifted:
      return Result::kLifted;
    case Phase::kRefused:
      return Result::kRefused;
    case Phase::kFailed:
      return Result::kFailed;
    case Phase::kStopped:
      // What is lifted stays lifted; a task that was under way did not succeed.
      return under_way(left) && so_far == Result::kNone ? Result::kFailed : so_far;
    default:
      return so_far;
  }
}

}  // namespace markservo::task_manager
