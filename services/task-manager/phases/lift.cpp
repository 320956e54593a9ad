#include "services/task-manager/phases/lift.hpp"

#include <string>

#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/phases/endings.hpp"
#include "services/task-manager/phases/retreat.hpp"
#include "services/task-manager/plans/carry_plan.hpp"
#include "services/task-manager/plans/lift_plan.hpp"

namespace markservo::task_manager {

std::optional<Transition> Lift::step(PhaseContext& context) {
  const MoveReport report = moves_.step(context);
  if (report.state != MoveState::kDone) return not_done(report);
  return Transition{Verify(), "measuring both marks after the lift"};
}

std::optional<Transition> Verify::step(PhaseContext& context) {
  const LiftParameters& parameters = context.parameters.lift;
  const std::int64_t pose_utime = context.input.pose_utime;
  if (context.clock.at(pose_utime) > since_) {
    marks_.observe(pose_utime, context.target_mark(), context.hand_mark());
  }
  if (marks_.count() >= parameters.frames) return judge(context);
  if (context.seconds_since(since_) <= parameters.marks_timeout) return std::nullopt;
  return let_go(context, "the lift cannot be verified: " + context.describe_unseen());
}

Transition Verify::judge(PhaseContext& context) const {
  const LiftParameters& parameters = context.parameters.lift;
  const Task& task = context.task;
  const double height = task.place.check_height;
  const LiftVerdict verdict = check_lift(context.arm(), task.at_grip, marks_.view(context.input.arm->q),
                                         {height, parameters.follow_share * height, parameters.rise_share});
  if (!verdict.came_along) return let_go(context, "the object did not come along: " + verdict.reason);
  context.notices.push_back("the object comes along: " + verdict.reason);
  const PosturePath up =
      plan_lift(context.arm(), context.parameters, context.grip(), context.arm_goals.newest().q,
                robot::grip_point(context.arm(), task.at_grip.q), parameters.height, context.closed());
  if (!up.reachable()) return failed("it cannot be lifted on: " + up.trouble());
  return {LiftOn(up.moves()), "lifting on"};
}

std::optional<Transition> LiftOn::step(PhaseContext& context) {
  const MoveReport report = moves_.step(context);
  if (report.state != MoveState::kDone) return not_done(report);
  const Task& task = context.task;
  if (!task.command.carry) return Transition{HoldLifted(), ""};
  const CarryPlan plan = plan_carry(context.arm(), context.parameters, context.grip(),
                                    {task.place.p_CT, task.at_grip.q}, context.arm_goals.newest().q, context.closed());
  if (!plan.trouble.empty()) return failed("it cannot be carried: " + plan.trouble);
  return Transition{Carry(plan.moves), "carrying to the side"};
}

}  // namespace markservo::task_manager
