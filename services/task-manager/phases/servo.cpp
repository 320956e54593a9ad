#include "services/task-manager/phases/servo.hpp"

#include <string>
#include <utility>

#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/phases/retreat.hpp"

namespace markservo::task_manager {

// Sends the stage's goal.
void Servo::aim(PhaseContext& context) {
  const bool grip_point = stage_ == Stage::kToTheGripPoint;
  const ServoParameters& parameters = context.parameters.servo;
  since_ = context.now();
  context.reason = grip_point ? "servoing to the grip point" : "servoing to the line of approach";
  Goal goal;
  goal.kind = GoalKind::kServo;
  goal.target = context.task.command.target;
  goal.p_TG = context.grip().p_TG - Eigen::Vector3d(0.0, grip_point ? 0.0 : context.task.place.standoff, 0.0);
  goal.tolerance = grip_point ? parameters.grip_tolerance : parameters.standoff_tolerance;
  goal.opening = context.arm().gripper.opening_max;
  goal.force = context.grip_force();
  context.arm_goals.set(std::move(goal));
}

std::optional<Transition> Servo::step(PhaseContext& context) {
  const ServoReport& servo = context.input.servo;
  const ServoParameters& parameters = context.parameters.servo;
  const bool answers = servo.goal_id == context.arm_goals.newest().id;
  const bool is_lost = answers && servo.state == ServoState::kLost;
  const double lost = lost_.observe(is_lost, context.now());

  if (answers && servo.state == ServoState::kConverged) {
    if (stage_ == Stage::kToTheGripPoint) return Transition{Grip(), "closing the hand"};
    stage_ = Stage::kToTheGripPoint;
    aim(context);
    return std::nullopt;
  }
  if (answers && servo.state == ServoState::kUnreachable) {
    return back_off(context, "the hand cannot come to the grip point: " + servo.reason);
  }
  if (lost > parameters.lost_timeout) {
    return back_off(context, "lost from sight: " + (servo.reason.empty() ? context.describe_unseen() : servo.reason));
  }
  if (context.seconds_since(since_) > parameters.timeout) {
    return back_off(context, "servoing did not come to its end in time");
  }
  return std::nullopt;
}

}  // namespace markservo::task_manager
