#include "services/task-manager/phases/release.hpp"

#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/phases/endings.hpp"
#include "services/task-manager/plans/approach_plan.hpp"

namespace markservo::task_manager {

std::optional<Transition> Release::step(PhaseContext& context) {
  const MoveReport report = moves_.step(context);
  if (report.state != MoveState::kDone) return not_done(report);
  context.holding.release();
  switch (then_) {
    case Then::kLookAgain:
      return look_again(context);
    case Then::kFail:
      return failed(failure_);
    case Then::kGoHome:
    case Then::kGoHomeCarried:
      break;
  }
  return go_home(context);
}

Transition Release::look_again(PhaseContext& context) const {
  ++context.task.attempt;
  context.task.failure = failure_;
  return {Look(), "once more: " + failure_};
}

Transition Release::go_home(PhaseContext& context) const {
  const Goal& told = context.arm_goals.newest();
  const PosturePath path = plan_home(context.arm(), context.parameters, {told.q, told.opening});
  if (!path.reachable()) return failed("no way home: " + path.trouble());
  return {GoHome(path.moves(), then_ == Then::kGoHomeCarried), "on the way home"};
}

std::optional<Transition> GoHome::step(PhaseContext& context) {
  const MoveReport report = moves_.step(context);
  if (report.state != MoveState::kDone) return not_done(report);
  if (carried_) context.task.result = Result::kLifted;
  return Transition{Done(), ""};
}

}  // namespace markservo::task_manager
