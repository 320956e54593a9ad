#include "services/visual-servo/servo_state_machine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "common/motion/freshness.hpp"
#include "common/robot/arm_kinematics.hpp"
#include "services/visual-servo/goal_check.hpp"
#include "services/visual-servo/in_flight.hpp"
#include "services/visual-servo/mark_lookup.hpp"
#include "services/visual-servo/paper_law.hpp"

namespace markservo::visual_servo {
namespace {

constexpr double kNominalFrame_s = 1.0 / 30.0;
constexpr double kShortestFrame_s = 1.0 / 120.0;
constexpr double kLongestFrame_s = 0.1;  // a longer gap must not become a longer step
constexpr double kStands_s = 0.3;        // without a command, by then the arm stands: nothing is left to slow down from
constexpr double kRampReserve = 1.05;    // ramps end a little before the next command
constexpr double kSlowestRamp = 0.2;     // rad/s
constexpr double kAtOnce_s = 0.008;      // a step of this length outruns the motor, and ends within a servo's pulse
constexpr double kNegligibleStep = 1e-4;  // rad
constexpr double kPlaceKnown_s = 0.03;  // of agreeing joint states after a leap, before the arm is taken where they say

}  // namespace

ServoStateMachine::ServoStateMachine(robot::RobotDescription robot, Parameters parameters)
    : robot_(std::move(robot)), parameters_(parameters) {
  if (!robot_.arm) throw std::invalid_argument("visual-servo: robot.yaml has no arm");
  arm_ = *robot_.arm;
  for (const auto& mark : robot_.marks) {
    if (mark.role == robot::MarkRole::kManipulator) hand_name_ = mark.name;
  }
  if (hand_name_.empty()) throw std::invalid_argument("visual-servo: robot.yaml has no mark of role manipulator");
  if (parameters_.law == Law::kPaper && !robot_.paper_law) {
    throw std::invalid_argument("visual-servo: robot.yaml has no paper_law, needed by law 'paper'");
  }
  for (int i = 0; i < robot::kNumJoints; ++i) servo_speed_[i] = arm_.joints[static_cast<std::size_t>(i)].speed;
}

bool ServoStateMachine::observe(const JointSample& sample, State& state) const {
  if (!sample.position.allFinite() || !std::isfinite(sample.gripper_opening)) return false;
  const bool first = state.joints.empty();
  if (state.joints.add(sample, servo_speed_)) state.adopt_joints = true;
  // A goal that came before any time did is judged now, so that none waits for its hour.
  if (first && state.goals.end_unless_fresh(sample.utime, parameters_.goal_age)) {
    state.dropped = "the goal heard before the first JOINT_STATE is of another time: it was dropped";
    state.goal.reset();
  }
  const bool obeying = state.commanded && !state.adopt_joints && !state.stop_latched.value_or(true);
  watch_gripper(sample, state.command.gripper_opening, state.gripper_utime, obeying, state.gripper);
  return true;
}

motion::GoalHeard ServoStateMachine::observe(const Goal& goal, State& state) const {
  const std::int64_t now = state.joints.empty() ? 0 : state.joints.newest().utime;
  const bool latched = state.stop_latched.value_or(false);
  const auto heard = state.goals.hear({goal.session, goal.id, goal.utime}, now, parameters_.goal_age, latched);
  if (!state.goals.goal()) state.goal.reset();
  if (heard == motion::GoalHeard::kAgain) state.goal->utime = state.goals.goal()->utime;
  if (heard != motion::GoalHeard::kNew) return heard;
  state.goal = goal;
  state.goal_refusal = why_goal_is_refused(robot_, goal);
  state.dropped.clear();
  state.adopted_in_hold = false;
  state.target.forget();
  state.sight = SightState();
  state.paper_frames = 0;
  return heard;
}

void ServoStateMachine::observe_stop(bool latched, const std::string& reason, State& state) const {
  const bool was_latched = state.stop_latched.value_or(false);
  state.stop_latched = latched;
  state.stop_reason = reason;
  // Even if the reset comes before the next picture: what was commanded before the stop must not be resumed.
  if (latched || was_latched) state.adopt_joints = true;
  if (!latched) return;
  state.goals.end();
  state.goal.reset();
}

void ServoStateMachine::begin_anew(const std::string& why, State& state) const {
  state.joints.forget();
  state.adopt_joints = true;
  if (state.goal) state.dropped = why + ": the goal was dropped";
  state.goals.end();
  state.goal.reset();
  begin_pictures_anew(state);
}

void ServoStateMachine::begin_pictures_anew(State& state) const {
  state.frame_session = 0;
  state.pose_utime = 0;
}

Output ServoStateMachine::step(const PoseSample& pose, State& state) const {
  Output output;
  Status& status = output.status;
  if (state.goal) {
    status.goal_session = state.goal->session;
    status.goal_id = state.goal->id;
  }
  if (state.joints.empty()) {
    status.state = ServoState::kStale;
    status.reason = "no JOINT_STATE yet";
    return output;
  }
  const std::string stale = why_stale(pose, state);
  if (!state.commanded || (state.adopt_joints && stale.empty())) adopt_joints(state);
  // One picture with an impossible time must not make all that follow look old.
  if (stale.empty()) advance_time(pose, state);

  if (!state.blocked.empty()) {
    hold(state);
    adopt_gripper(state);
    status.state = ServoState::kStopped;
    status.reason = state.blocked;
  } else if (!state.stop_latched || *state.stop_latched) {
    hold(state);
    // A stopped arm rests short of its command: begin from there.
    if (state.joints.newest().position != state.command.position) adopt_joints(state);
    adopt_gripper(state);
    status.state = ServoState::kStopped;
    status.reason = !state.stop_latched ? "no STOP_STATE of the arm yet" : state.stop_reason;
    if (status.reason.empty()) status.reason = "STOP is latched";
  } else if (!stale.empty()) {
    hold(state);
    status.state = ServoState::kStale;
    status.reason = stale;
  } else if (const std::string goal_stale = why_goal_is_stale(state); !goal_stale.empty()) {
    state.sight.window.clear();
    state.paper_frames = 0;
    slow_down(state);
    adopt_gripper(state);
    status.state = ServoState::kStale;
    status.reason = goal_stale;
  } else {
    follow_goal(pose, state, status);
  }
  // Nothing is left to be fast for: a word in this one's name could ask for no far step.
  if (at_rest_since(parameters_.sight.settling, state.joints, state.command.position, state.command_utime)) {
    state.command.speed_limit.setConstant(kSlowestRamp);
  }
  state.command.joint_session = state.joints.newest().session;
  output.command = state.command;
  return output;
}

void ServoStateMachine::advance_time(const PoseSample& pose, State& state) const {
  if (pose.frame_session != state.frame_session) {
    state.frame_session = pose.frame_session;
    state.seconds = kNominalFrame_s;
    state.target.forget();
    state.sight = SightState();
    state.pose_utime = pose.utime;
  } else if (pose.utime > state.pose_utime) {
    if (seconds_between(state.pose_utime, pose.utime) > kStands_s) hold(state);
    state.seconds = std::clamp(seconds_between(state.pose_utime, pose.utime), kShortestFrame_s, kLongestFrame_s);
    state.pose_utime = pose.utime;
  }
}

void ServoStateMachine::adopt_joints(State& state) const {
  const JointSample& now = state.joints.newest();
  state.command.position = now.position;
  // Nothing is to move by it: slow, so that an arm that is elsewhere refuses it as leading its shafts too far.
  state.command.speed_limit.setConstant(kSlowestRamp);
  state.command_utime = now.utime;
  state.adopt_joints = false;
  state.last_step.setZero();
  state.sight = SightState();
  state.paper_frames = 0;
  if (state.commanded) return adopt_gripper(state);
  state.commanded = true;
  // Until a goal is learned the gripper stays as it is; one that holds something goes on pressing.
  set_opening(now.contact ? 0.0 : now.gripper_opening, state);
  state.command.gripper_force = arm_.gripper.force_max;
}

std::string ServoStateMachine::why_stale(const PoseSample& pose, const State& state) const {
  if (!pose.doubt.empty()) return pose.doubt;
  const motion::Freshness rule{"TARGET_POSE", "JOINT_STATE", parameters_.pose_age, parameters_.joint_age};
  if (auto why = why_not_fresh(rule, pose.utime, state.joints.newest().utime); !why.empty()) return why;
  if (pose.frame_session == state.frame_session && pose.utime <= state.pose_utime) {
    return "TARGET_POSE is not newer than the one before";
  }
  return "";
}

std::string ServoStateMachine::why_goal_is_stale(const State& state) const {
  if (!state.goal) return "";
  const motion::Freshness rule{"SERVO_GOAL", "JOINT_STATE", parameters_.goal_age, parameters_.goal_age};
  return why_not_fresh(rule, state.goal->utime, state.joints.newest().utime);
}

void ServoStateMachine::follow_goal(const PoseSample& pose, State& state, Status& status) const {
  const JointSample& now = state.joints.newest();
  const SettlingParameters& settling = parameters_.sight.settling;
  const bool elsewhere = (now.position - state.command.position).cwiseAbs().maxCoeff() > parameters_.lost_arm;
  const bool holds = !state.goal || state.goal->kind == GoalKind::kHold;
  const bool rests_elsewhere =
      elsewhere && at_rest_since(settling, state.joints, state.command.position, state.command_utime).has_value();
  // Once only while it holds: an arm that sags, or a report that is wrong, would lead it on without end.
  if (rests_elsewhere && !(holds && state.adopted_in_hold)) {
    adopt_joints(state);
    state.adopted_in_hold = holds;
  } else if (rests_elsewhere) {
    status.reason = "the arm does not rest where it is told to";
  }
  status.settled = at_rest_since(settling, state.joints, state.command.position, state.command_utime).has_value();
  if (!state.goal) {
    status.state = ServoState::kHold;
    if (status.reason.empty()) status.reason = state.dropped.empty() ? "no goal" : state.dropped;
    slow_down(state);
    adopt_gripper(state);
    return;
  }
  const Goal& goal = *state.goal;
  if (!state.goal_refusal.empty()) {
    status.state = ServoState::kUnreachable;
    status.reason = state.goal_refusal;
    slow_down(state);
    return;
  }
  set_gripper(goal, state);
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

void ServoStateMachine::slow_down(State& state) const {
  if (state.last_step.isZero()) return;
  state.waiting += state.seconds;
  state.last_step *= std::pow(parameters_.slow_down_factor, state.seconds / kNominalFrame_s);
  if (state.waiting > parameters_.slow_down_time || state.last_step.cwiseAbs().maxCoeff() < kNegligibleStep) {
    hold(state);
    return;
  }
  state.command.position = inside_limits(arm_, state.command.position + state.last_step);
  state.command_utime = state.joints.newest().utime;
}

void ServoStateMachine::move(const JointVector& step, bool at_once, bool streaming, State& state,
                             Status& status) const {
  const JointVector next = state.command.position + step;
  const JointVector lead = (next - state.joints.newest().position).cwiseAbs();
  int joint = 0;
  if (lead.maxCoeff(&joint) > parameters_.follow_lead) {
    hold(state);
    status.reason = "the arm does not follow: joint " + arm_.joints[static_cast<std::size_t>(joint)].name;
    return;
  }
  state.waiting = 0.0;
  if (streaming) {
    state.last_step = step;
  } else {
    hold(state);
  }
  if (step.isZero()) return;
  state.command.position = next;
  state.command_utime = state.joints.newest().utime;
  const JointVector streamed = (step.cwiseAbs() * (kRampReserve / state.seconds)).cwiseMax(kSlowestRamp);
  JointVector speed = streaming ? streamed : JointVector::Constant(parameters_.sight.rate.joint_speed);
  if (at_once) speed = (step.cwiseAbs() / kAtOnce_s).cwiseMax(kSlowestRamp);
  state.command.speed_limit = speed.cwiseMin(servo_speed_);
}

void ServoStateMachine::move_to_posture(State& state, Status& status) const {
  const Goal& goal = *state.goal;
  const JointVector q_goal(goal.position[0], goal.position[1], goal.position[2]);
  status.state = ServoState::kPosture;
  const double speed_before = state.last_step.cwiseAbs().maxCoeff() / state.seconds;
  const JointVector step = posture_step(arm_, parameters_.posture, state.command.position, q_goal, state.seconds,
                                        grip_speed_limit(goal), speed_before);
  move(step, false, true, state, status);
  if (step.isZero()) hold(state);
  const auto rest =
      at_rest_since(parameters_.sight.settling, state.joints, state.command.position, state.command_utime);
  status.settled = step.isZero() && rest &&
                   seconds_between(*rest, state.joints.newest().utime) >= parameters_.sight.settling.settle_time;
}

void ServoStateMachine::servo(const PoseSample& pose, State& state, Status& status) const {
  const Goal& goal = *state.goal;
  const MarkSample* hand = find(pose, hand_name_);
  const MarkSample* target = find(pose, goal.target);
  status.state = ServoState::kLost;
  status.settled = false;
  status.reason = why_lost(target, goal.target);
  if (status.reason.empty()) {
    state.target.see(parameters_.target, target->p_C, target->covariance);
    status.reason = why_lost(hand, hand_name_);
  }
  if (status.reason.empty()) {
    const double mismatch = kinematic_bias(arm_, state.joints.at(pose.utime), hand->p_C).norm();
    if (mismatch > parameters_.hand_mismatch) {
      char text[128];
      std::snprintf(text, sizeof text, "mark %s: %.3f m from where the joints say it is, allowed %.3f m",
                    hand_name_.c_str(), mismatch, parameters_.hand_mismatch);
      status.reason = text;
    }
  }
  if (!status.reason.empty()) {
    state.sight.window.clear();
    slow_down(state);
    return;
  }
  if (parameters_.law == Law::kPaper) {
    servo_paper(pose, *hand, state, status);
  } else {
    servo_resolved_rate(pose, *hand, state, status);
  }
}

void ServoStateMachine::servo_resolved_rate(const PoseSample& pose, const MarkSample& hand, State& state,
                                            Status& status) const {
  const Goal& goal = *state.goal;
  Sight sight;
  sight.utime = pose.utime;
  sight.seconds = state.seconds;
  sight.q_exposure = state.joints.at(pose.utime);
  sight.p_CM = hand.p_C;
  sight.p_CG_goal = state.target.position() + goal.p_TG_C;
  sight.tolerance = goal.tolerance;
  sight.grip_speed = grip_speed_limit(goal);
  sight.speed_before =
      (robot::grip_point_jacobian(arm_, state.command.position) * state.last_step).norm() / state.seconds;
  const SightAnswer answer = servo_by_sight(arm_, parameters_.sight, sight, state.joints, state.command.position,
                                            state.command_utime, state.sight);
  status.error = answer.error;
  status.covariance = state.target.covariance() + hand.covariance / answer.frames;
  status.settled = answer.settled;
  status.reason = answer.unreachable;
  if (!answer.unreachable.empty()) {
    status.state = ServoState::kUnreachable;
    slow_down(state);
    return;
  }
  status.state = answer.converged ? ServoState::kConverged : ServoState::kServo;
  move(answer.step, answer.at_once, answer.streaming, state, status);
}

void ServoStateMachine::servo_paper(const PoseSample& pose, const MarkSample& hand, State& state,
                                    Status& status) const {
  const Goal& goal = *state.goal;
  const SightParameters& parameters = parameters_.sight;
  const Eigen::Vector3d p_CG_goal = state.target.position() + goal.p_TG_C;
  const Eigen::Vector3d p_CG = seen_grip_point(arm_, state.joints.at(pose.utime), hand.p_C);
  status.error = p_CG - p_CG_goal;
  status.covariance = state.target.covariance() + hand.covariance;

  JointVector q_goal;
  const Eigen::Vector3d bias = kinematic_bias(arm_, state.joints.at(pose.utime), hand.p_C);
  status.reason = why_unreachable(arm_, p_CG_goal - bias, parameters.joint_margin, q_goal);
  if (!status.reason.empty()) {
    status.state = ServoState::kUnreachable;
    slow_down(state);
    return;
  }
  const auto* mark = robot_.find_mark(goal.target);
  const Eigen::Vector3d usual = mark->grip ? mark->grip->p_TG : goal.p_TG_C;
  const Eigen::Vector3d error = paper_error(*robot_.paper_law, hand.p_C, state.target.position(), goal.p_TG_C - usual);
  const double tolerance = goal.tolerance > 0.0 ? goal.tolerance : parameters.tolerance;
  state.paper_frames = error.norm() <= tolerance ? state.paper_frames + 1 : 0;
  const bool there = state.paper_frames >= parameters.settling.frames;
  status.state = there ? ServoState::kConverged : ServoState::kServo;
  status.settled = there;
  JointVector step = JointVector::Zero();
  if (!there) {
    step = paper_step(*robot_.paper_law, error, state.seconds, parameters.rate.joint_speed);
    step = inside_limits(arm_, state.command.position + step) - state.command.position;
  }
  move(step, false, !there, state, status);
}

double ServoStateMachine::grip_speed_limit(const Goal& goal) const {
  const double own = parameters_.sight.rate.grip_speed;
  return goal.speed > 0.0 ? std::min(goal.speed, own) : own;
}

}  // namespace markservo::visual_servo
