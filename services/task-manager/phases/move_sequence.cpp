#include "services/task-manager/phases/move_sequence.hpp"

namespace markservo::task_manager {

void MoveSequence::begin(PhaseContext& context) {
  index_ = 0;
  if (!moves_.empty()) send(context);
}

MoveReport MoveSequence::step(PhaseContext& context) {
  if (index_ >= moves_.size()) return {MoveState::kDone, ""};
  MoveReport report = watch_move(moves_[index_], context.arm_goals.newest().id, context.input, context.now(),
                                 context.parameters.motion, progress_);
  if (report.state != MoveState::kDone || ++index_ == moves_.size()) return report;
  send(context);
  return {};
}

void MoveSequence::send(PhaseContext& context) {
  const Move& move = moves_[index_];
  progress_ = MoveProgress();
  progress_.since = context.now();
  context.holding.observe_command(move.opening);
  Goal goal;
  goal.kind = move.hold ? GoalKind::kHold : GoalKind::kPosture;
  goal.q = move.q;
  goal.speed = move.speed;
  goal.opening = move.opening;
  goal.force = context.grip_force();
  context.arm_goals.set(std::move(goal));
}

}  // namespace markservo::task_manager
