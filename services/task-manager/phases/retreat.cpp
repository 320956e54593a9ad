#include "services/task-manager/phases/retreat.hpp"

#include "services/task-manager/phases/endings.hpp"
#include "services/task-manager/plans/lift_plan.hpp"

namespace markservo::task_manager {

Transition back_off(PhaseContext& context, const std::string& failure) {
  const MotionParameters& motion = context.parameters.motion;
  const Eigen::Vector3d& p_CG_first = context.task.place.p_CG_first;
  PosturePath path(context.arm(), context.input.arm->q, context.arm().gripper.opening_max, motion.joint_margin);
  if (path.end_point().y() > p_CG_first.y()) path.line_to(p_CG_first, motion.near_step, motion.near_speed);
  if (!path.reachable() || path.moves().empty()) return failed(failure);
  return {Release(path.moves(), Release::Then::kFail, failure), "backing off: " + failure};
}

Transition let_go(PhaseContext& context, const std::string& failure) {
  const Task& task = context.task;
  const Goal& told = context.arm_goals.newest();
  const bool on_its_way = told.kind == GoalKind::kPosture;
  const PosturePath path =
      plan_put_back(context.arm(), context.parameters, on_its_way ? told.q : context.input.arm->q,
                    robot::grip_point(context.arm(), task.at_grip.q), task.place.p_CG_first, context.closed());
  if (!path.reachable()) return failed(failure);
  const bool again = task.attempt == 1;
  return {Release(path.moves(), again ? Release::Then::kLookAgain : Release::Then::kFail, failure),
          (again ? "trying once more: " : "giving up: ") + failure};
}

}  // namespace markservo::task_manager
