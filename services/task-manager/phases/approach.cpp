#include "services/task-manager/phases/approach.hpp"

#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/phases/endings.hpp"
#include "services/task-manager/phases/retreat.hpp"

namespace markservo::task_manager {

std::optional<Transition> Approach::step(PhaseContext& context) {
  if (stage_ == Stage::kWaitingForTheHand) return wait_for_the_hand(context);
  const MoveReport report = moves_.step(context);
  if (report.state != MoveState::kDone) return not_done(report);
  stage_ = Stage::kWaitingForTheHand;
  since_ = context.now();
  pose_utime_ = context.input.pose_utime;
  context.reason = "waiting for the hand's mark";
  return std::nullopt;
}

std::optional<Transition> Approach::wait_for_the_hand(PhaseContext& context) {
  const ApproachParameters& parameters = context.parameters.approach;
  const MarkReport hand = context.hand_mark();
  if (context.input.pose_utime != pose_utime_) {
    pose_utime_ = context.input.pose_utime;
    hand_frames_ = hand.sight == Sight::kLocated ? hand_frames_ + 1 : 0;
  }
  if (hand_frames_ >= parameters.hand_frames) {
    const bool by_standoff = context.task.place.standoff >= parameters.standoff_worth_while;
    return Transition{Servo(by_standoff ? Servo::Stage::kToTheLine : Servo::Stage::kToTheGripPoint), ""};
  }
  if (context.seconds_since(since_) <= parameters.hand_timeout) return std::nullopt;
  return back_off(context, "the hand's mark is not seen: " + describe_sight(hand));
}

}  // namespace markservo::task_manager
