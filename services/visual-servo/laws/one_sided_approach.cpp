#include "services/visual-servo/laws/one_sided_approach.hpp"

#include <algorithm>
#include <cmath>

#include "services/visual-servo/arm/joint_limits.hpp"

namespace markservo::visual_servo {

JointVector ending_directions(const JointVector& q_now, const JointVector& q_goal) {
  return {q_goal[0] < q_now[0] ? -1.0 : 1.0, -1.0, 1.0};
}

JointVector entry_posture(const robot::ArmDescription& arm, const OneSidedParameters& parameters,
                          const JointVector& q_goal, const JointVector& directions) {
  return inside_limits(arm, q_goal - parameters.back_off * directions);
}

JointVector last_but_one(const OneSidedParameters& parameters, const JointVector& q_command, const JointVector& q_final,
                         const JointVector& directions) {
  JointVector q = q_command;
  for (int i = 0; i < robot::kNumJoints; ++i) {
    const double way = (q_final[i] - q_command[i]) * directions[i];
    if (way > parameters.last_move) q[i] = q_final[i] - directions[i] * parameters.last_move;
  }
  return q;
}

Correction plan_correction(const robot::ArmDescription& arm, const OneSidedParameters& parameters,
                           const JointVector& q_command, const JointVector& change, const JointVector& directions) {
  Correction correction;
  correction.via = correction.final = q_command;
  for (int i = 0; i < robot::kNumJoints; ++i) {
    if (std::abs(change[i]) < parameters.unchanged) continue;
    correction.final[i] = q_command[i] + change[i];
    const double forward = change[i] * directions[i];
    if (forward >= parameters.sure_move) continue;
    // The play is crossed backwards once, whichever way the change goes.
    correction.via[i] = q_command[i] + directions[i] * (std::min(forward, 0.0) - parameters.back_off);
    correction.backs_off = true;
  }
  correction.via = inside_limits(arm, correction.via);
  correction.final = inside_limits(arm, correction.final);
  return correction;
}

}  // namespace markservo::visual_servo
