#include "services/task-manager/phases/phase_context.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/time/seconds_between.hpp"
#include "services/task-manager/plans/approach_plan.hpp"
#include "services/task-manager/plans/lift_plan.hpp"

namespace markservo::task_manager {
namespace {

MarkReport find(const std::vector<MarkReport>& marks, const std::string& name) {
  for (const MarkReport& mark : marks) {
    if (mark.name == name) return mark;
  }
  return {name, std::nullopt, Eigen::Vector3d::Zero()};
}

// The opening, m, that keeps the gripper as it is; nothing while that is not known.
std::optional<double> kept_opening(const PhaseContext& context) {
  const double open = context.arm().gripper.opening_max;
  const std::optional<ArmReport>& arm = context.input.arm;
  if (context.arm_goals.none_yet()) {
    if (!arm) return std::nullopt;
    // After a restart: what is not open may be closed around something.
    return arm->gripper_opening < open - context.parameters.grip.open_enough ? 0.0 : open;
  }
  if (context.holding.holds_on(arm)) return context.closed();
  return arm ? std::clamp(arm->gripper_opening, 0.0, open) : context.arm_goals.newest().opening;
}

}  // namespace

double PhaseContext::seconds_since(std::int64_t task_time) const {
  return seconds_between(task_time, now());
}

MarkReport PhaseContext::target_mark() const {
  return find(input.marks, task.command.target);
}

MarkReport PhaseContext::hand_mark() const {
  return find(input.marks, hand_mark_of(robot)->name);
}

std::string PhaseContext::describe_unseen() const {
  const MarkReport mark = target_mark();
  return describe_sight(mark.sight == Sight::kLocated ? hand_mark() : mark);
}

double PhaseContext::closed() const {
  return closed_opening(parameters.grip, grip());
}

double PhaseContext::grip_force() const {
  return std::min(parameters.grip.force, arm().gripper.force_max);
}

void hold_arm(PhaseContext& context) {
  if (!context.robot.arm) return;
  const std::optional<double> opening = kept_opening(context);
  if (!opening) return;
  Goal goal;
  goal.kind = GoalKind::kHold;
  goal.opening = *opening;
  goal.force = context.grip_force();
  context.arm_goals.set(std::move(goal));
}

}  // namespace markservo::task_manager
