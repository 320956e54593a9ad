#include "services/visual-servo/laws/servo_by_sight.hpp"

#include <utility>

#include "common/robot/arm_kinematics.hpp"
#include "services/visual-servo/arm/goal_check.hpp"
#include "services/visual-servo/laws/law_state.hpp"
#include "services/visual-servo/sight/in_flight.hpp"

namespace markservo::visual_servo {
namespace {

using Phase = SightState::Phase;

// What every phase needs of one frame.
struct Frame {
  const robot::ArmDescription& arm;
  const SightParameters& parameters;
  const LawInput& input;
  const JointVector& q_command;  // rad
  Eigen::Vector3d p_CG;          // m, seen
  Eigen::Vector3d p_CG_goal;     // m
  double tolerance;              // m
};

bool rests(const Frame& frame, std::int64_t utime) {
  return frame.input.command.settled_at(frame.parameters.settling, frame.input.joints, utime);
}

// The grip point's in the last step, m/s.
double speed_before(const Frame& frame) {
  return (robot::grip_point_jacobian(frame.arm, frame.q_command) * frame.input.command.last_step()).norm() /
         frame.input.seconds;
}

// Two moves in the ending directions, a frame apart: to the last but one posture, and home.
void enter(const JointVector& q_goal, const Frame& frame, SightState& state, LawAnswer& answer) {
  answer.step.change =
      last_but_one(frame.parameters.one_sided, frame.q_command, q_goal, state.directions) - frame.q_command;
  answer.step.joint_speed = frame.parameters.rate.joint_speed;
  state.final = q_goal;
  state.phase = Phase::kEnter;
}

// What the frames since the entry's begin have told of the goal, as far as the last move bears it.
void refine_entry(const Frame& frame, SightState& state) {
  const SightParameters& parameters = frame.parameters;
  JointVector q_goal = state.final;
  const Eigen::Vector3d p_CG = frame.p_CG_goal - state.bias.at(frame.arm, state.final, state.directions);
  if (!why_unreachable(frame.arm, p_CG, parameters.joint_margin, q_goal).empty()) return;
  const double most = parameters.one_sided.refined_part * parameters.one_sided.last_move;
  state.final += (q_goal - state.final).cwiseMax(-most).cwiseMin(most);
}

void finish_entry(const Frame& frame, SightState& state, LawAnswer& answer) {
  if (state.corrections == 0) refine_entry(frame, state);
  answer.step.change = state.final - frame.q_command;
  state.window.forget();
  state.phase = Phase::kSettle;
}

void approach(const Frame& frame, SightState& state, LawAnswer& answer) {
  const SightParameters& parameters = frame.parameters;
  JointVector q_goal = frame.q_command;
  const bool begins = state.phase != Phase::kApproach;
  // The bias at the goal depends a little on the posture there and on how the joints arrive, and these on the bias.
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d p_CG = frame.p_CG_goal - state.bias.at(frame.arm, q_goal, state.directions);
    answer.unreachable = why_unreachable(frame.arm, p_CG, parameters.joint_margin, q_goal);
    if (!answer.unreachable.empty()) return;
    if (begins) state.directions = ending_directions(frame.q_command, q_goal);
  }
  if (begins) {
    state.phase = Phase::kApproach;
    state.corrections = 0;
  }
  const JointVector q_entry = entry_posture(frame.arm, parameters.one_sided, q_goal, state.directions);
  const Eigen::Vector3d to_go =
      robot::grip_point(frame.arm, q_entry) - robot::grip_point(frame.arm, frame.q_command);  // the bias cancels
  const Eigen::Vector3d unseen =
      robot::grip_point(frame.arm, frame.q_command) - robot::grip_point(frame.arm, frame.input.sighting.q_exposure);
  if (to_go.norm() <= parameters.entry_radius && unseen.norm() <= parameters.entry_unseen) {
    enter(q_goal, frame, state, answer);
    return;
  }
  answer.step.change = resolved_rate_step(frame.arm, parameters.rate, frame.q_command, to_go, frame.input.seconds,
                                          frame.input.grip_speed, speed_before(frame));
  answer.step.streaming = true;
}

void correct(const Frame& frame, const Eigen::Vector3d& error, SightState& state, LawAnswer& answer) {
  ++state.corrections;
  const JointVector change = damped_joint_step(robot::grip_point_jacobian(frame.arm, frame.input.sighting.q_exposure),
                                               -error, frame.parameters.rate.damping);
  const Correction correction =
      plan_correction(frame.arm, frame.parameters.one_sided, frame.q_command, change, state.directions);
  if (!correction.backs_off) {
    enter(correction.final, frame, state, answer);
    return;
  }
  answer.step.change = correction.via - frame.q_command;
  answer.step.joint_speed = frame.parameters.rate.joint_speed;
  state.final = correction.final;
  state.phase = Phase::kBackOff;
}

void settle(const Frame& frame, SightState& state, LawAnswer& answer) {
  if (!rests(frame, frame.input.sighting.utime)) return;
  const SightParameters& parameters = frame.parameters;
  answer.settled = true;
  state.window.add(parameters.settling, frame.p_CG);
  answer.frames = state.window.size();
  answer.error = state.window.mean() - frame.p_CG_goal;
  if (!state.window.ready(parameters.settling)) return;

  const double error = answer.error.norm();
  const bool many_frames = answer.frames >= parameters.settling.frames_in_doubt;
  switch (judge(parameters.convergence, frame.tolerance, state.corrections, error, many_frames)) {
    case Verdict::kConverged:
      state.phase = Phase::kConverged;
      answer.converged = true;
      break;
    case Verdict::kInDoubt:
      state.window.look_longer();
      break;
    case Verdict::kOff:
      if (error > parameters.far) {
        approach(frame, state, answer);
      } else {
        correct(frame, answer.error, state, answer);
      }
      break;
  }
}

void stay_converged(const Frame& frame, SightState& state, LawAnswer& answer) {
  state.window.add(frame.parameters.settling, frame.p_CG);
  answer.settled = true;
  answer.frames = state.window.size();
  answer.error = state.window.mean() - frame.p_CG_goal;
  answer.converged = stays_converged(frame.parameters.convergence, frame.tolerance, answer.error.norm());
  if (!answer.converged) {
    state.phase = Phase::kSettle;
    state.corrections = 0;
    state.window.forget();
  }
}

}  // namespace

ServoBySight::ServoBySight(robot::ArmDescription arm, const SightParameters& parameters)
    : arm_(std::move(arm)), parameters_(parameters) {}

LawAnswer ServoBySight::step(const LawInput& input, LawState& law_state) const {
  SightState& state = law_state.sight;
  const Sighting& sighting = input.sighting;
  const JointVector& q_command = input.command.position();
  const JointMotion joints{sighting.q_exposure, input.joints.speed(sighting.utime),
                           input.joints.trailing(sighting.utime)};
  state.bias.observe(arm_, parameters_.bias, joints, sighting.p_CM);
  const Frame frame{arm_,
                    parameters_,
                    input,
                    q_command,
                    seen_grip_point(arm_, state.bias.shafts(joints.q, joints.trailing), sighting.p_CM),
                    input.p_CG_goal(),
                    tolerance_of(parameters_.convergence, input.goal.tolerance)};
  LawAnswer answer;
  answer.error = frame.p_CG - frame.p_CG_goal;
  const Eigen::Vector3d error_to_come =
      predicted_grip_point(arm_, q_command, state.bias.at(arm_, q_command, joints.trailing)) - frame.p_CG_goal;
  const bool astray = error_to_come.norm() > 2.0 * parameters_.far;
  if (state.phase == Phase::kStart && error_to_come.norm() <= parameters_.near) {
    state.directions = ending_directions(q_command, q_command);
    state.phase = Phase::kSettle;
  }
  if (state.phase == Phase::kStart || state.phase == Phase::kApproach || astray) {
    approach(frame, state, answer);
  } else if (state.phase == Phase::kBackOff) {
    if (rests(frame, input.joints.newest().utime)) enter(state.final, frame, state, answer);
  } else if (state.phase == Phase::kEnter) {
    finish_entry(frame, state, answer);
  } else if (state.phase == Phase::kSettle) {
    settle(frame, state, answer);
  } else {
    stay_converged(frame, state, answer);
  }
  return answer;
}

}  // namespace markservo::visual_servo
