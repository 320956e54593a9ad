#include "services/task-manager/phases/grip.hpp"

#include <string>

#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/phases/endings.hpp"
#include "services/task-manager/phases/retreat.hpp"
#include "services/task-manager/plans/lift_plan.hpp"

namespace markservo::task_manager {

void Grip::begin(PhaseContext& context) {
  Move close;
  close.hold = true;
  close.opening = context.closed();
  close.dwell = context.parameters.grip.close_time;
  closing_ = MoveSequence({close});
  closing_.begin(context);
}

std::optional<Transition> Grip::step(PhaseContext& context) {
  return stage_ == Stage::kClosing ? close(context) : measure(context);
}

std::optional<Transition> Grip::close(PhaseContext& context) {
  const MoveReport report = closing_.step(context);
  if (report.state != MoveState::kDone) return not_done(report);
  const ArmReport& arm = *context.input.arm;
  context.holding.grip(arm, context.grip().object_width);
  context.task.at_grip.q = arm.q;
  stage_ = Stage::kMeasuring;
  since_ = context.now();
  context.reason = "measuring both marks before the lift";
  return std::nullopt;
}

std::optional<Transition> Grip::measure(PhaseContext& context) {
  const LiftParameters& parameters = context.parameters.lift;
  const Input& input = context.input;
  if (context.clock.at(input.pose_utime) > since_) {
    marks_.observe(input.pose_utime, context.target_mark(), context.hand_mark());
  }
  if (marks_.count() < parameters.frames) {
    if (context.seconds_since(since_) <= parameters.marks_timeout) return std::nullopt;
    return let_go(context, "the grip cannot be verified: " + context.describe_unseen());
  }
  Task& task = context.task;
  task.at_grip = marks_.view(input.arm->q);
  const Eigen::Vector3d p_CG = robot::grip_point(context.arm(), task.at_grip.q);
  const PosturePath up = plan_lift(context.arm(), context.parameters, context.grip(), task.at_grip.q, p_CG,
                                   task.place.check_height, context.closed());
  if (!up.reachable()) return let_go(context, "it cannot be lifted: " + up.trouble());
  return Transition{Lift(up.moves()), "lifting a little"};
}

}  // namespace markservo::task_manager
