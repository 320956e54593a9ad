#include "services/visual-servo/servo_by_sight.hpp"

#include <algorithm>
#include <cmath>

#include "common/robot/arm_kinematics.hpp"
#include "services/visual-servo/goal_check.hpp"
#include "services/visual-servo/in_flight.hpp"

namespace markservo::visual_servo {
namespace {

using Phase = SightState::Phase;

// What every phase needs of one frame.
struct Frame {
  const robot::ArmDescription& arm;
  const SightParameters& parameters;
  const Sight& sight;
  const JointHistory& joints;
  const JointVector& q_command;
  std::int64_t command_utime;
  Eigen::Vector3d p_CG;  // m, seen
  double tolerance;      // m
};

bool rests(const Frame& frame, std::int64_t utime) {
  const auto since = at_rest_since(frame.parameters.settling, frame.joints, frame.q_command, frame.command_utime);
  return since && seconds_between(*since, utime) >= frame.parameters.settling.settle_time;
}

// Two moves in the ending directions, a frame apart: to the last but one posture, and home.
void enter(const JointVector& q_goal, const Frame& frame, SightState& state, SightAnswer& answer) {
  answer.step = last_but_one(frame.parameters.one_sided, frame.q_command, q_goal, state.directions) - frame.q_command;
  state.final = q_goal;
  state.phase = Phase::kEnter;
}

// What the frames since the entry's begin have told of the goal, as far as the last move bears it.
void refine_entry(const Frame& frame, SightState& state) {
  const SightParameters& parameters = frame.parameters;
  JointVector q_goal = state.final;
  const Eigen::Vector3d p_CG = frame.sight.p_CG_goal - state.bias.at(frame.arm, state.final, state.directions);
  if (!why_unreachable(frame.arm, p_CG, parameters.joint_margin, q_goal).empty()) return;
  const double most = parameters.one_sided.refined_part * parameters.one_sided.last_move;
  state.final += (q_goal - state.final).cwiseMax(-most).cwiseMin(most);
}

void finish_entry(const Frame& frame, SightState& state, SightAnswer& answer) {
  if (state.corrections == 0) refine_entry(frame, state);
  answer.step = state.final - frame.q_command;
  answer.at_once = true;
  state.window.clear();
  state.phase = Phase::kSettle;
}

void approach(const Frame& frame, SightState& state, SightAnswer& answer) {
  const SightParameters& parameters = frame.parameters;
  JointVector q_goal = frame.q_command;
  const bool begins = state.phase != Phase::kApproach;
  // The bias at the goal depends a little on the posture there and on how the joints arrive, and these on the bias.
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d p_CG = frame.sight.p_CG_goal - state.bias.at(frame.arm, q_goal, state.directions);
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
      robot::grip_point(frame.arm, frame.q_command) - robot::grip_point(frame.arm, frame.sight.q_exposure);
  if (to_go.norm() <= parameters.entry_radius && unseen.norm() <= parameters.entry_unseen) {
    enter(q_goal, frame, state, answer);
    return;
  }
  answer.step = resolved_rate_step(frame.arm, parameters.rate, frame.q_command, to_go, frame.sight.seconds,
                                   frame.sight.grip_speed, frame.sight.speed_before);
  answer.streaming = true;
}

void correct(const Frame& frame, const Eigen::Vector3d& error, SightState& state, SightAnswer& answer) {
  ++state.corrections;
  const JointVector change = damped_joint_step(robot::grip_point_jacobian(frame.arm, frame.sight.q_exposure), -error,
                                               frame.parameters.rate.damping);
  const Correction correction =
      plan_correction(frame.arm, frame.parameters.one_sided, frame.q_command, change, state.directions);
  if (!correction.backs_off) {
    enter(correction.final, frame, state, answer);
    return;
  }
  answer.step = correction.via - frame.q_command;
  state.final = correction.final;
  state.phase = Phase::kBackOff;
}

// How fast the joints came to where they were at the exposure, rad/s: what they trail behind comes of the past.
JointVector speed_at(const JointHistory& joints, std::int64_t utime) {
  constexpr std::int64_t kSpan_us = 30'000;
  return (joints.at(utime) - joints.at(utime - kSpan_us)) / seconds_between(0, kSpan_us);
}

// The error that is aimed at: finer than asked at first, so that the goal is met with something in hand.
double fine_error(const Frame& frame, const SightState& state) {
  const SightParameters& parameters = frame.parameters;
  if (state.corrections >= parameters.fine_corrections) return frame.tolerance;
  return std::min(frame.tolerance, std::max(parameters.fine_tolerance, parameters.fine_part * frame.tolerance));
}

void settle(const Frame& frame, SightState& state, SightAnswer& answer) {
  if (!rests(frame, frame.sight.utime)) return;
  const SightParameters& parameters = frame.parameters;
  answer.settled = true;
  state.window.add(parameters.settling, frame.p_CG);
  answer.frames = state.window.size();
  answer.error = state.window.mean() - frame.sight.p_CG_goal;
  if (!state.window.ready(parameters.settling)) return;

  const double error = answer.error.norm();
  const double fine = fine_error(frame, state);
  const bool sure = answer.frames >= parameters.settling.frames_in_doubt;
  if (error <= fine || (sure && error <= frame.tolerance - parameters.sure)) {
    state.phase = Phase::kConverged;
    answer.converged = true;
  } else if (!sure && error <= fine + parameters.doubt) {
    state.window.look_longer();
  } else if (error > parameters.far) {
    approach(frame, state, answer);
  } else {
    correct(frame, answer.error, state, answer);
  }
}

void stay_converged(const Frame& frame, SightState& state, SightAnswer& answer) {
  state.window.add(frame.parameters.settling, frame.p_CG);
  answer.settled = true;
  answer.frames = state.window.size();
  answer.error = state.window.mean() - frame.sight.p_CG_goal;
  const double leave =
      std::max(frame.parameters.leave_factor * frame.tolerance, frame.tolerance + frame.parameters.leave_margin);
  answer.converged = answer.error.norm() <= leave;
  if (!answer.converged) {
    state.phase = Phase::kSettle;
    state.corrections = 0;
    state.window.clear();
  }
}

}  // namespace

SightAnswer servo_by_sight(const robot::ArmDescription& arm, const SightParameters& parameters, const Sight& sight,
                           const JointHistory& joints, const JointVector& q_command, std::int64_t command_utime,
                           SightState& state) {
  const Frame frame{arm,
                    parameters,
                    sight,
                    joints,
                    q_command,
                    command_utime,
                    seen_grip_point(arm, sight.q_exposure, sight.p_CM),
                    sight.tolerance > 0.0 ? sight.tolerance : parameters.tolerance};
  state.bias.see(arm, parameters.bias, sight.q_exposure, speed_at(joints, sight.utime), sight.p_CM);

  SightAnswer answer;
  answer.error = frame.p_CG - sight.p_CG_goal;
  const Eigen::Vector3d error_to_come =
      predicted_grip_point(arm, q_command, state.bias.at(arm, q_command, state.bias.directions())) - sight.p_CG_goal;
  const bool astray = error_to_come.norm() > 2.0 * parameters.far;
  if (state.phase == Phase::kStart && error_to_come.norm() <= parameters.near) {
    state.directions = ending_directions(q_command, q_command);
    state.phase = Phase::kSettle;
  }
  if (state.phase == Phase::kStart || state.phase == Phase::kApproach || astray) {
    approach(frame, state, answer);
  } else if (state.phase == Phase::kBackOff) {
    if (rests(frame, joints.newest().utime)) enter(state.final, frame, state, answer);
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
