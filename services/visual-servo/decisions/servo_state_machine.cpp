#include "services/visual-servo/decisions/servo_state_machine.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/motion/freshness.hpp"
#include "services/visual-servo/arm/goal_check.hpp"
#include "services/visual-servo/arm/joint_limits.hpp"
#include "services/visual-servo/laws/paper_law.hpp"

namespace markservo::visual_servo {
namespace {

std::unique_ptr<const ServoLaw> law_of(const robot::RobotDescription& robot, const Parameters& parameters) {
  const SightParameters& sight = parameters.sight;
  if (parameters.law == Law::kResolvedRate) return std::make_unique<ServoBySight>(*robot.arm, sight);
  const PaperParameters paper{sight.convergence.tolerance, sight.settling.frames, sight.rate.joint_speed,
                              sight.joint_margin};
  return std::make_unique<PaperLaw>(robot, paper);
}

void decide(ServoState state, const std::string& reason, Status& status) {
  status.state = state;
  status.reason = reason;
}

}  // namespace

ServoStateMachine::ServoStateMachine(robot::RobotDescription robot, Parameters parameters)
    : robot_(std::move(robot)), parameters_(parameters) {
  if (!robot_.arm) throw std::invalid_argument("visual-servo: robot.yaml has no arm");
  arm_ = *robot_.arm;
  for (const auto& mark : robot_.marks) {
    if (mark.role == robot::MarkRole::kManipulator) hand_name_ = mark.name;
  }
  if (hand_name_.empty()) throw std::invalid_argument("visual-servo: robot.yaml has no mark of role manipulator");
  law_ = law_of(robot_, parameters_);
}

bool ServoStateMachine::observe(const JointSample& sample, State& state) const {
  if (!sample.position.allFinite() || !std::isfinite(sample.gripper_opening)) return false;
  const bool first = state.joints.empty();
  if (state.joints.add(sample, servo_speeds(arm_), state.law.sight.bias.play())) state.command.require_adoption();
  if (first) state.followed.end_unless_fresh(sample.utime, parameters_.goal_age);
  const bool obeying = state.command.begun() && !state.command.adoption_due() && state.enable.released();
  state.gripper.observe(sample, obeying);
  return true;
}

motion::GoalHeard ServoStateMachine::observe(const Goal& goal, State& state) const {
  const std::int64_t now = state.joints.empty() ? 0 : state.joints.newest().utime;
  const auto heard = state.followed.observe(goal, now, parameters_.goal_age, state.enable.latched());
  if (heard != motion::GoalHeard::kNew) return heard;
  state.followed.refuse(why_goal_is_refused(robot_, goal));
  state.lost.forget();
  state.marks.forget();
  state.law.forget();
  return heard;
}

void ServoStateMachine::observe_stop(bool latched, const std::string& reason, State& state) const {
  // Even if the reset comes before the next picture: what was commanded before the stop must not be resumed.
  if (latched || state.enable.latched()) state.command.require_adoption();
  state.enable.observe_stop(latched, reason);
  if (latched) state.followed.end();
}

void ServoStateMachine::begin_anew(const std::string& why, State& state) const {
  state.joints.forget();
  state.command.require_adoption();
  state.followed.drop(why);
  state.pictures.begin_anew();
}

void ServoStateMachine::begin_pictures_anew(State& state) const {
  state.pictures.begin_anew();
}

Output ServoStateMachine::step(const PoseSample& pose, State& state) const {
  Output output;
  Status& status = output.status;
  if (const auto& goal = state.followed.goal()) {
    status.goal_session = goal->session;
    status.goal_id = goal->id;
  }
  if (state.joints.empty()) {
    decide(ServoState::kStale, "no JOINT_STATE yet", status);
    return output;
  }
  const std::string stale = why_stale(pose, state);
  if (!state.command.begun() || (state.command.adoption_due() && stale.empty())) adopt_joints(state);
  // One picture with an impossible time must not make all that follow look old.
  if (stale.empty()) advance_time(pose, state);

  if (!state.enable.conflict().empty()) {
    state.command.hold();
    state.gripper.adopt(arm_.gripper, state.joints.newest());
    decide(ServoState::kStopped, state.enable.conflict(), status);
  } else if (!state.enable.released()) {
    state.command.hold();
    // A stopped arm rests short of its command: begin from there.
    if (state.joints.newest().position != state.command.position()) adopt_joints(state);
    state.gripper.adopt(arm_.gripper, state.joints.newest());
    decide(ServoState::kStopped, state.enable.why_stopped(), status);
  } else if (!stale.empty()) {
    state.command.hold();
    decide(ServoState::kStale, stale, status);
  } else if (const std::string goal_stale = state.followed.why_stale(state.joints.newest().utime, parameters_.goal_age);
             !goal_stale.empty()) {
    state.law.interrupt();
    slow_down(state);
    state.gripper.adopt(arm_.gripper, state.joints.newest());
    decide(ServoState::kStale, goal_stale, status);
  } else {
    follow_goal(pose, state, status);
  }
  state.command.relax(parameters_.sight.settling, state.joints);
  output.command = {state.command.position(), state.command.speed_limit(), state.joints.newest().session,
                    state.gripper.opening(), state.gripper.force()};
  return output;
}

void ServoStateMachine::advance_time(const PoseSample& pose, State& state) const {
  switch (state.pictures.advance(pose)) {
    case Succession::kOfAnotherWriter:
      state.marks.forget();
      state.law.forget_pictures();
      break;
    case Succession::kAfterAGap:
      state.command.hold();
      break;
    case Succession::kNext:
      break;
  }
}

void ServoStateMachine::adopt_joints(State& state) const {
  state.command.adopt(state.joints.newest());
  state.gripper.adopt(arm_.gripper, state.joints.newest());
  state.law.begin_anew();
}

std::string ServoStateMachine::why_stale(const PoseSample& pose, const State& state) const {
  if (!pose.doubt.empty()) return pose.doubt;
  const motion::Freshness rule{"TARGET_POSE", "JOINT_STATE", parameters_.pose_age, parameters_.joint_age};
  if (auto why = why_not_fresh(rule, pose.utime, state.joints.newest().utime); !why.empty()) return why;
  return state.pictures.has_passed(pose) ? "TARGET_POSE is not newer than the one before" : "";
}

void ServoStateMachine::follow_goal(const PoseSample& pose, State& state, Status& status) const {
  const JointSample& now = state.joints.newest();
  status.reason = adopt_lost_arm(state);
  status.settled = state.command.at_rest_since(parameters_.sight.settling, state.joints).has_value();
  if (!state.followed.goal()) {
    status.state = ServoState::kHold;
    if (status.reason.empty()) status.reason = state.followed.why_none();
    slow_down(state);
    state.gripper.adopt(arm_.gripper, now);
    return;
  }
  const Goal& goal = *state.followed.goal();
  if (!state.followed.refusal().empty()) {
    decide(ServoState::kUnreachable, state.followed.refusal(), status);
    slow_down(state);
    return;
  }
  state.gripper.follow(arm_.gripper, goal, now.utime);
  switch (goal.kind) {
    case GoalKind::kPosture:
      move_to_posture(state, status);
      break;
    case GoalKind::kServo:
      servo(pose, state, status);
      break;
    case GoalKind::kHold:
    case GoalKind::kUnknown:
      status.state = ServoState::kHold;
      slow_down(state);
      break;
  }
}

std::string ServoStateMachine::adopt_lost_arm(State& state) const {
  const JointVector& q_now = state.joints.newest().position;
  const bool elsewhere = (q_now - state.command.position()).cwiseAbs().maxCoeff() > parameters_.lost_arm;
  if (!elsewhere || !state.command.at_rest_since(parameters_.sight.settling, state.joints)) return "";
  if (!state.lost.adopts(state.followed.holds())) return "the arm does not rest where it is told to";
  adopt_joints(state);
  return "";
}

void ServoStateMachine::slow_down(State& state) const {
  state.command.slow_down(arm_, parameters_.command, state.joints.newest().utime, state.pictures.seconds());
}

void ServoStateMachine::move(const ArmStep& step, State& state, Status& status) const {
  status.reason = state.command.move(arm_, parameters_.command, step, state.joints.newest(), state.pictures.seconds());
}

void ServoStateMachine::move_to_posture(State& state, Status& status) const {
  const Goal& goal = *state.followed.goal();
  const JointVector q_goal(goal.position[0], goal.position[1], goal.position[2]);
  status.state = ServoState::kPosture;
  const double seconds = state.pictures.seconds();
  const double speed_before = state.command.last_step().cwiseAbs().maxCoeff() / seconds;
  const JointVector step = posture_step(arm_, parameters_.posture, state.command.position(), q_goal, seconds,
                                        grip_speed_limit(goal), speed_before);
  move({step, true}, state, status);
  if (step.isZero()) state.command.hold();
  status.settled =
      step.isZero() && state.command.settled_at(parameters_.sight.settling, state.joints, state.joints.newest().utime);
}

void ServoStateMachine::servo(const PoseSample& pose, State& state, Status& status) const {
  const Goal& goal = *state.followed.goal();
  const Sighting sighting =
      state.marks.observe(parameters_.marks, arm_, pose, state.joints.at(pose.utime), hand_name_, goal.target);
  status.settled = false;
  if (!sighting.lost.empty()) {
    decide(ServoState::kLost, sighting.lost, status);
    state.law.lose_sight();
    slow_down(state);
    return;
  }
  const double seconds = state.pictures.seconds();
  const LawInput input{goal, sighting, state.joints, state.command, seconds, grip_speed_limit(goal)};
  const LawAnswer answer = law_->step(input, state.law);
  status.error = answer.error;
  status.covariance = sighting.target_covariance + sighting.hand_covariance / answer.frames;
  status.settled = answer.settled;
  if (!answer.unreachable.empty()) {
    decide(ServoState::kUnreachable, answer.unreachable, status);
    slow_down(state);
    return;
  }
  status.state = answer.converged ? ServoState::kConverged : ServoState::kServo;
  move(answer.step, state, status);
}

double ServoStateMachine::grip_speed_limit(const Goal& goal) const {
  const double own = parameters_.sight.rate.grip_speed;
  return goal.speed > 0.0 ? std::min(goal.speed, own) : own;
}

}  // namespace markservo::visual_servo
