#include "services/task-manager/watches/move_watch.hpp"

#include <fmt/format.h>

#include "common/time/seconds_between.hpp"

namespace markservo::task_manager {
namespace {

bool there(const Move& move, const Input& input, double pass_tolerance) {
  if (move.hold) return true;
  if (input.servo.state == ServoState::kPosture && input.servo.settled) return true;
  return !move.settle && input.arm && (input.arm->q - move.q).cwiseAbs().maxCoeff() < pass_tolerance;
}

}  // namespace

MoveReport watch_move(const Move& move, std::int64_t goal_id, const Input& input, std::int64_t now,
                      const MotionParameters& parameters, MoveProgress& progress) {
  const bool answered = input.servo.goal_id == goal_id;
  if (answered && input.servo.state == ServoState::kUnreachable) {
    return {MoveState::kFailed, "the arm cannot take a posture: " + input.servo.reason};
  }
  const bool answered_in_motion =
      answered && input.servo.state != ServoState::kStale && input.servo.state != ServoState::kStopped;
  if (!progress.there && answered_in_motion && there(move, input, parameters.pass_tolerance)) {
    progress.there = now;
  }
  if (progress.there && seconds_between(*progress.there, now) >= move.dwell) return {MoveState::kDone, ""};
  if (seconds_between(progress.since, now) > parameters.move_timeout + move.dwell) {
    if (!answered) return {MoveState::kFailed, "visual-servo does not answer the goal"};
    return {MoveState::kFailed,
            fmt::format("the arm did not come to a posture within {:.1f} s", parameters.move_timeout)};
  }
  return {};
}

}  // namespace markservo::task_manager
