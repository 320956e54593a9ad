#include "services/task-manager/phases/look.hpp"

#include <utility>

#include "common/robot/workspace.hpp"
#include "services/task-manager/guards.hpp"
#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/phases/endings.hpp"
#include "services/task-manager/plans/pick_plan.hpp"

namespace markservo::task_manager {
namespace {

std::string why_unseen(const PhaseContext& context) {
  const MarkReport mark = context.target_mark();
  if (const auto& p_CT_expected = context.task.command.p_CT_expected) {
    const robot::GripJudgement judgement = robot::judge_grip(context.robot, context.target(), *p_CT_expected);
    if (judgement.verdict == robot::GripVerdict::kUnreachable) {
      return std::string(robot::name_of(judgement.verdict)) + ": " + judgement.reason;
    }
  }
  return std::string(robot::name_of(robot::GripVerdict::kOutOfView)) + ": " +
         (mark.sight == Sight::kLocated ? "no frame comes in" : describe_sight(mark));
}

// A drive that brings the target, seen at `p_CT` where it cannot be taken, into the middle of the workspace; nothing
// where that is not tried.
std::optional<Transition> drive_nearer(PhaseContext& context, const Eigen::Vector3d& p_CT, const std::string& trouble) {
  constexpr double kPointless = 0.01;  // m: the target stands as wished, and still cannot be taken
  const DriveParameters& parameters = context.parameters.drive;
  Task& task = context.task;
  if (!task.driven || task.attempt > 1 || task.corrections >= parameters.corrections) return std::nullopt;
  const Eigen::Vector2d off = p_CT.head<2>() - Eigen::Vector2d(context.arm().p_CA.x(), parameters.target_depth);
  if (off.norm() < kPointless || off.norm() > parameters.correction_max) return std::nullopt;
  ++task.corrections;
  context.notices.push_back("driving nearer, since " + trouble);
  // R's axes are C's: its x is C's y, its y is C's -x.
  return Transition{Drive::on_by({off.y(), -off.x(), 0.0}), ""};
}

}  // namespace

void Look::begin(PhaseContext& context) {
  since_ = seen_ = context.now();
}

std::optional<Transition> Look::step(PhaseContext& context) {
  const Input& input = context.input;
  const LookParameters& parameters = context.parameters.look;
  const MarkReport mark = context.target_mark();
  if (mark.sight == Sight::kLocated && context.clock.at(input.pose_utime) >= since_) {
    target_.add(input.pose_utime, mark.p_C);
    seen_ = context.now();
  }
  const bool all_answer = input.arm && input.stop.known;
  if (target_.count() >= parameters.frames && all_answer) return decide(context);
  if (context.seconds_since(seen_) > parameters.unseen_time) return not_taken(context, why_unseen(context));
  if (context.seconds_since(since_) <= parameters.timeout) return std::nullopt;
  if (!all_answer) return not_taken(context, who_is_silent(input));
  return not_taken(context, "out_of_view: the mark of " + context.task.command.target + " was located in " +
                                std::to_string(target_.count()) + " frames only");
}

Transition Look::decide(PhaseContext& context) const {
  const Eigen::Vector3d p_CT = target_.mean();
  const ArmReport& arm = *context.input.arm;
  PickPlan plan = plan_pick(context.robot, context.parameters, context.target(), p_CT, {arm.q, arm.gripper_opening},
                            context.task.command.carry);
  if (!plan.trouble.empty()) {
    if (auto nearer = drive_nearer(context, p_CT, plan.trouble)) return std::move(*nearer);
    return not_taken(context, plan.trouble);
  }
  context.task.place = plan.place;
  return {Approach(std::move(plan.approach)), "bringing the hand before " + context.task.command.target};
}

}  // namespace markservo::task_manager
