#include "services/task-manager/plans/pick_plan.hpp"

#include "common/robot/arm_kinematics.hpp"
#include "common/robot/workspace.hpp"
#include "services/task-manager/plans/carry_plan.hpp"
#include "services/task-manager/plans/lift_plan.hpp"

namespace markservo::task_manager {
namespace {

// Why what is gripped at `p_CT` could not be lifted, or then not be carried; empty if it could.
std::string trouble_after_the_grip(const robot::ArmDescription& arm, const Parameters& parameters,
                                   const robot::GripDescription& grip, const Eigen::Vector3d& p_CT, bool carry) {
  const double closed = closed_opening(parameters.grip, grip);
  const Eigen::Vector3d p_CG = p_CT + grip.p_TG;
  const robot::JointVector q_grip = robot::inverse_kinematics(arm, p_CG, 0.0).q;
  const PosturePath up = plan_lift(arm, parameters, grip, q_grip, p_CG, parameters.lift.height, closed);
  if (!up.reachable()) return "it could not be lifted: " + up.trouble();
  if (!carry) return "";
  const CarryPlan plan = plan_carry(arm, parameters, grip, {p_CT, q_grip}, up.end(), closed);
  return plan.trouble.empty() ? "" : "it could not be carried: " + plan.trouble;
}

}  // namespace

PickPlan plan_pick(const robot::RobotDescription& robot, const Parameters& parameters,
                   const robot::MarkDescription& target, const Eigen::Vector3d& p_CT, const HandState& hand,
                   bool carry) {
  PickPlan plan;
  const robot::GripJudgement judgement = robot::judge_grip(robot, target, p_CT);
  if (judgement.verdict != robot::GripVerdict::kFeasible) {
    plan.trouble = std::string(robot::name_of(judgement.verdict)) + ": " + judgement.reason;
    return plan;
  }
  const std::string unreachable = std::string(robot::name_of(robot::GripVerdict::kUnreachable)) + ": ";
  const ApproachPlan approach = plan_approach(robot, parameters, target, p_CT, hand);
  const std::string trouble = approach.trouble.empty()
                                  ? trouble_after_the_grip(*robot.arm, parameters, *target.grip, p_CT, carry)
                                  : approach.trouble;
  if (!trouble.empty()) {
    plan.trouble = unreachable + trouble;
    return plan;
  }
  plan.approach = approach.moves;
  plan.place = {p_CT, approach.p_CG_first, approach.standoff, check_height(robot, parameters, target, p_CT)};
  return plan;
}

}  // namespace markservo::task_manager
