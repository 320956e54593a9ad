#include "services/task-manager/phases/carry.hpp"

#include <string>

#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/phases/endings.hpp"
#include "services/task-manager/plans/carry_plan.hpp"

namespace markservo::task_manager {

void Carry::begin(PhaseContext& context) {
  context.holding.carry_away();
  moves_.begin(context);
}

std::optional<Transition> Carry::step(PhaseContext& context) {
  const MoveReport report = moves_.step(context);
  if (report.state != MoveState::kDone) return not_done(report);
  const PosturePath path =
      plan_release(context.arm(), context.parameters, context.arm_goals.newest().q, context.closed());
  if (!path.reachable()) return failed("the hand cannot leave it: " + path.trouble());
  return Transition{Release(path.moves(), Release::Then::kGoHomeCarried), "letting go"};
}

}  // namespace markservo::task_manager
