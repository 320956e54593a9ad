// The phases of figure 11, one function each.

#include <algorithm>

#include "common/robot/workspace.hpp"
#include "services/task-manager/plans/carry_plan.hpp"
#include "services/task-manager/plans/lift_plan.hpp"
#include "services/task-manager/procedure_step.hpp"

namespace markservo::task_manager {

void ProcedureStep::run_phase() {
  switch (s_.phase) {
    case Phase::kDrive:
      return drive();
    case Phase::kLook:
      return look();
    case Phase::kApproach:
      return approach();
    case Phase::kServo:
      return servo();
    case Phase::kGrip:
      return grip();
    case Phase::kLift:
      return lift();
    case Phase::kVerify:
      return verify();
    case Phase::kLiftOn:
      return lift_on();
    case Phase::kCarry:
      return carry();
    case Phase::kRelease:
      return release();
    case Phase::kGoHome:
      return go_home();
    default:
      return;
  }
}

void ProcedureStep::look() {
  const MarkReport mark = sight_of(s_.task.target);
  if (mark.sight == Sight::kLocated && in_.pose_utime >= s_.since) {
    s_.target_mean.add(in_.pose_utime, mark.p_C);
    s_.seen_utime = in_.utime;
  }
  const bool located = s_.target_mean.count() >= p_.look.frames;
  if (located && in_.arm && in_.stop.known) {
    decide();
  } else if (seconds_between(s_.seen_utime, in_.utime) > p_.look.unseen_time) {
    tell_why_unseen();
  } else if (waited() > p_.look.timeout) {
    if (!in_.arm || !in_.stop.known) return not_taken(who_is_silent());
    not_taken("out_of_view: the mark of " + s_.task.target + " was located in " +
              std::to_string(s_.target_mean.count()) + " frames only");
  }
}

void ProcedureStep::tell_why_unseen() {
  const MarkReport mark = sight_of(s_.task.target);
  std::string reason = std::string(robot::name_of(robot::GripVerdict::kOutOfView)) + ": " +
                       (mark.sight == Sight::kLocated ? "no frame comes in" : describe_sight(mark));
  if (s_.task.p_CT_expected) {
    const auto judgement = robot::judge_grip(robot_, target(), *s_.task.p_CT_expected);
    if (judgement.verdict == robot::GripVerdict::kUnreachable) {
      reason = std::string(robot::name_of(judgement.verdict)) + ": " + judgement.reason;
    }
  }
  not_taken(reason);
}

std::string ProcedureStep::who_is_silent() const {
  if (!in_.arm) return "the arm does not answer: no JOINT_STATE";
  return "not every stop device answers: no STOP_STATE of " + in_.stop.silent;
}

// The target cannot be taken: refused, or failed when the base has driven or the arm has tried once.
void ProcedureStep::not_taken(const std::string& reason) {
  if (s_.attempt > 1) {
    fail(s_.failure + "; and then: " + reason);
  } else if (s_.drive.driven) {
    fail("after the drive: " + reason);
  } else {
    refuse(reason);
  }
}

void ProcedureStep::decide() {
  s_.p_CT = s_.target_mean.mean();
  const robot::GripDescription& grip_of = *target().grip;
  const HandState hand{in_.arm->q, in_.arm->gripper_opening};
  const auto judgement = robot::judge_grip(robot_, target(), s_.p_CT);
  std::string trouble;
  ApproachPlan plan;
  if (judgement.verdict != robot::GripVerdict::kFeasible) {
    trouble = std::string(robot::name_of(judgement.verdict)) + ": " + judgement.reason;
  } else {
    plan = plan_approach(robot_, p_, target(), s_.p_CT, hand);
    if (!plan.trouble.empty()) trouble = "unreachable: " + plan.trouble;
  }
  if (trouble.empty()) {
    // All that follows must be possible before anything moves.
    const Eigen::Vector3d p_CG = s_.p_CT + grip_of.p_TG;
    const auto q_grip = robot::inverse_kinematics(arm(), p_CG, 0.0).q;
    const PosturePath up = plan_lift(arm(), p_, grip_of, q_grip, p_CG, p_.lift.height, closed_opening());
    if (!up.reachable()) {
      trouble = std::string("unreachable: it could not be lifted: ") + robot::describe(up.status());
    } else if (s_.task.carry) {
      const CarryPlan way = plan_carry(arm(), p_, grip_of, {s_.p_CT, q_grip}, up.end(), closed_opening());
      if (!way.trouble.empty()) trouble = "unreachable: it could not be carried: " + way.trouble;
    }
  }
  if (!trouble.empty()) return corrects_the_stand(trouble) ? void() : not_taken(trouble);
  s_.standoff = plan.standoff;
  s_.p_CG_first = plan.p_CG_first;
  s_.check_height = check_height(robot_, p_, target(), s_.p_CT);
  enter(Phase::kApproach, "bringing the hand before " + s_.task.target);
  play(plan.moves);
}

void ProcedureStep::approach() {
  if (s_.stage == 0) {
    if (!way_is_done()) return;
    s_.hand_frames = 0;
    s_.pose_utime = in_.pose_utime;
    return enter_stage(1, "waiting for the hand's mark");
  }
  const MarkReport hand = sight_of(hand_mark_of(robot_)->name);
  if (in_.pose_utime != s_.pose_utime) {
    s_.pose_utime = in_.pose_utime;
    s_.hand_frames = hand.sight == Sight::kLocated ? s_.hand_frames + 1 : 0;
  }
  if (s_.hand_frames >= p_.approach.hand_frames) {
    const bool by_standoff = s_.standoff >= p_.approach.standoff_worth_while;
    enter(Phase::kServo, "");
    begin_servo(by_standoff ? 0 : 1);
  } else if (waited() > p_.approach.hand_timeout) {
    back_off("the hand's mark is not seen: " + describe_sight(hand));
  }
}

// Stage 0: before the spines; stage 1: the grip point.
void ProcedureStep::begin_servo(int stage) {
  const bool grip_point = stage == 1;
  enter_stage(stage, grip_point ? "servoing to the grip point" : "servoing to the line of approach");
  Goal goal;
  goal.kind = GoalKind::kServo;
  goal.target = s_.task.target;
  goal.p_TG = target().grip->p_TG - Eigen::Vector3d(0.0, grip_point ? 0.0 : s_.standoff, 0.0);
  goal.tolerance = grip_point ? p_.servo.grip_tolerance : p_.servo.standoff_tolerance;
  goal.opening = arm().gripper.opening_max;
  goal.force = std::min(p_.grip.force, arm().gripper.force_max);
  send(goal);
}

void ProcedureStep::servo() {
  const bool answers = in_.servo.goal_id == s_.goal.id;
  const bool lost = answers && in_.servo.state == ServoState::kLost;
  if (!lost) s_.lost_since.reset();
  if (lost && !s_.lost_since) s_.lost_since = in_.utime;

  if (answers && in_.servo.state == ServoState::kConverged) {
    if (s_.stage == 0) return begin_servo(1);
    Move close;
    close.hold = true;
    close.opening = closed_opening();
    close.dwell = p_.grip.close_time;
    enter(Phase::kGrip, "closing the hand");
    return play({close});
  }
  if (answers && in_.servo.state == ServoState::kUnreachable) {
    return back_off("the hand cannot come to the grip point: " + in_.servo.reason);
  }
  if (lost && seconds_between(*s_.lost_since, in_.utime) > p_.servo.lost_timeout) {
    return back_off("lost from sight: " + (in_.servo.reason.empty() ? unseen_marks() : in_.servo.reason));
  }
  if (waited() > p_.servo.timeout) back_off("servoing did not come to its end in time");
}

void ProcedureStep::grip() {
  if (s_.stage == 0) {
    if (!way_is_done()) return;
    s_.holding = {true, true, false, in_.arm->session, in_.arm->q};
    s_.before.q = in_.arm->q;
    s_.target_mean = s_.hand_mean = MarkAverage();
    return enter_stage(1, "measuring both marks before the lift");
  }
  if (average_both_marks()) {
    s_.before = {s_.target_mean.mean(), s_.hand_mean.mean(), in_.arm->q};
    const Eigen::Vector3d p_CG = robot::grip_point(arm(), s_.before.q);
    const PosturePath up = plan_lift(arm(), p_, *target().grip, s_.before.q, p_CG, s_.check_height, closed_opening());
    if (!up.reachable()) return grip_failed(std::string("it cannot be lifted: ") + robot::describe(up.status()));
    enter(Phase::kLift, "lifting a little");
    play(up.moves());
  } else if (waited() > p_.lift.marks_timeout) {
    grip_failed("the grip cannot be verified: " + unseen_marks());
  }
}

void ProcedureStep::lift() {
  if (!way_is_done()) return;
  s_.target_mean = s_.hand_mean = MarkAverage();
  enter(Phase::kVerify, "measuring both marks after the lift");
}

void ProcedureStep::verify() {
  if (average_both_marks()) {
    const LiftView after{s_.target_mean.mean(), s_.hand_mean.mean(), in_.arm->q};
    const LiftVerdict verdict = check_lift(
        arm(), s_.before, after, {s_.check_height, p_.lift.follow_share * s_.check_height, p_.lift.rise_share});
    if (!verdict.came_along) return grip_failed("the book did not come along: " + verdict.reason);
    out_.notices.push_back("the book comes along: " + verdict.reason);
    const PosturePath up = plan_lift(arm(), p_, *target().grip, s_.goal.q, robot::grip_point(arm(), s_.before.q),
                                     p_.lift.height, closed_opening());
    if (!up.reachable()) return fail(std::string("it cannot be lifted on: ") + robot::describe(up.status()));
    enter(Phase::kLiftOn, "lifting on");
    play(up.moves());
  } else if (waited() > p_.lift.marks_timeout) {
    grip_failed("the lift cannot be verified: " + unseen_marks());
  }
}

void ProcedureStep::lift_on() {
  if (!way_is_done()) return;
  if (!s_.task.carry) {
    s_.result = Result::kLifted;
    return enter(Phase::kHoldLifted, "");
  }
  const CarryPlan way = plan_carry(arm(), p_, *target().grip, {s_.p_CT, s_.before.q}, s_.goal.q, closed_opening());
  if (!way.trouble.empty()) return fail("it cannot be carried: " + way.trouble);
  s_.holding.over_place = false;
  enter(Phase::kCarry, "carrying to the side");
  play(way.moves);
}

void ProcedureStep::carry() {
  if (!way_is_done()) return;
  const PosturePath path = plan_release(arm(), p_, s_.goal.q, closed_opening());
  if (!path.reachable()) return fail(std::string("the hand cannot leave it: ") + robot::describe(path.status()));
  s_.after_release = AfterRelease::kHomeCarried;
  enter(Phase::kRelease, "letting go");
  play(path.moves());
}

void ProcedureStep::release() {
  if (!way_is_done()) return;
  s_.holding.something = false;
  switch (s_.after_release) {
    case AfterRelease::kLookAgain:
      ++s_.attempt;
      s_.target_mean = MarkAverage();
      return enter(Phase::kLook, "once more: " + s_.failure);
    case AfterRelease::kFail:
      return fail(s_.failure);
    case AfterRelease::kHome:
    case AfterRelease::kHomeCarried:
      break;
  }
  const PosturePath path = plan_home(arm(), p_, {s_.goal.q, s_.goal.opening});
  if (!path.reachable()) return fail(std::string("no way home: ") + robot::describe(path.status()));
  enter(Phase::kGoHome, "on the way home");
  play(path.moves());
}

void ProcedureStep::go_home() {
  if (!way_is_done()) return;
  if (s_.after_release == AfterRelease::kHomeCarried) s_.result = Result::kLifted;
  enter(Phase::kDone, "");
}

// Takes in this frame; true when enough of them show both marks since the stage began.
bool ProcedureStep::average_both_marks() {
  const MarkReport object = sight_of(s_.task.target);
  const MarkReport hand = sight_of(hand_mark_of(robot_)->name);
  if (in_.pose_utime > s_.since && object.sight == Sight::kLocated && hand.sight == Sight::kLocated) {
    s_.target_mean.add(in_.pose_utime, object.p_C);
    s_.hand_mean.add(in_.pose_utime, hand.p_C);
  }
  return s_.target_mean.count() >= p_.lift.frames;
}

std::string ProcedureStep::unseen_marks() const {
  const MarkReport object = sight_of(s_.task.target);
  return describe_sight(object.sight == Sight::kLocated ? sight_of(hand_mark_of(robot_)->name) : object);
}

// The open hand leaves the books on the line on which it came; then the task has failed.
void ProcedureStep::back_off(const std::string& failure) {
  PosturePath path(arm(), in_.arm->q, arm().gripper.opening_max, p_.motion.joint_margin);
  if (path.end_point().y() > s_.p_CG_first.y()) path.line_to(s_.p_CG_first, p_.motion.near_step, p_.motion.near_speed);
  if (!path.reachable() || path.moves().empty()) return fail(failure);
  s_.failure = failure;
  s_.after_release = AfterRelease::kFail;
  enter(Phase::kRelease, "backing off: " + failure);
  play(path.moves());
}

void ProcedureStep::grip_failed(const std::string& failure) {
  const bool on_its_way = s_.goal.kind == GoalKind::kPosture;
  const PosturePath path = plan_put_back(arm(), p_, on_its_way ? s_.goal.q : in_.arm->q,
                                         robot::grip_point(arm(), s_.before.q), s_.p_CG_first, closed_opening());
  if (!path.reachable()) return fail(failure);
  s_.failure = failure;
  s_.after_release = s_.attempt == 1 ? AfterRelease::kLookAgain : AfterRelease::kFail;
  enter(Phase::kRelease, (s_.attempt == 1 ? "trying once more: " : "giving up: ") + failure);
  play(path.moves());
}

}  // namespace markservo::task_manager
