#include "services/visual-servo/laws/paper_law.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "services/visual-servo/arm/goal_check.hpp"
#include "services/visual-servo/arm/joint_limits.hpp"
#include "services/visual-servo/laws/law_state.hpp"
#include "services/visual-servo/sight/in_flight.hpp"

namespace markservo::visual_servo {

Eigen::Vector3d paper_error(const robot::PaperLawDescription& law, const Eigen::Vector3d& p_CM,
                            const Eigen::Vector3d& p_CT, const Eigen::Vector3d& shift_TG) {
  return p_CM - (p_CT + law.offset_TM + shift_TG);
}

robot::JointVector paper_step(const robot::PaperLawDescription& law, const Eigen::Vector3d& error, double seconds,
                              double joint_speed) {
  const robot::JointVector rate = law.gains.cwiseProduct(error);
  return rate.cwiseMax(-joint_speed).cwiseMin(joint_speed) * seconds;
}

PaperLaw::PaperLaw(robot::RobotDescription robot, const PaperParameters& parameters)
    : robot_(std::move(robot)), parameters_(parameters) {
  if (!robot_.paper_law) {
    throw std::invalid_argument("visual-servo: robot.yaml has no paper_law, needed by law 'paper'");
  }
}

LawAnswer PaperLaw::step(const LawInput& input, LawState& state) const {
  const robot::ArmDescription& arm = *robot_.arm;
  const robot::PaperLawDescription& law = *robot_.paper_law;
  const Goal& goal = input.goal;
  const Sighting& sighting = input.sighting;
  LawAnswer answer;
  const Eigen::Vector3d p_CG_goal = input.p_CG_goal();
  answer.error = seen_grip_point(arm, sighting.q_exposure, sighting.p_CM) - p_CG_goal;
  const Eigen::Vector3d bias = kinematic_bias(arm, sighting.q_exposure, sighting.p_CM);
  JointVector q_goal;
  answer.unreachable = why_unreachable(arm, p_CG_goal - bias, parameters_.joint_margin, q_goal);
  if (!answer.unreachable.empty()) return answer;

  const auto* mark = robot_.find_mark(goal.target);
  const Eigen::Vector3d usual = mark->grip ? mark->grip->p_TG : goal.p_TG_C;
  const Eigen::Vector3d error = paper_error(law, sighting.p_CM, sighting.p_CT, goal.p_TG_C - usual);
  const double tolerance = goal.tolerance > 0.0 ? goal.tolerance : parameters_.tolerance;
  int& frames = state.paper.frames;
  frames = error.norm() <= tolerance ? frames + 1 : 0;
  answer.converged = answer.settled = frames >= parameters_.frames;
  if (answer.converged) return answer;
  const JointVector step = paper_step(law, error, input.seconds, parameters_.joint_speed);
  answer.step.change = inside_limits(arm, input.command.position() + step) - input.command.position();
  answer.step.streaming = true;
  return answer;
}

}  // namespace markservo::visual_servo
