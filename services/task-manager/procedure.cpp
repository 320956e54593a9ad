#include "services/task-manager/procedure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "services/task-manager/lift_plan.hpp"
#include "services/task-manager/procedure_step.hpp"

namespace markservo::task_manager {
namespace {

constexpr std::int64_t kWorthAWord_us = 500'000;
constexpr double kOpened = 0.006;  // m wider than the object: the hand does not hold it

}  // namespace

Procedure::Procedure(robot::RobotDescription robot, Parameters parameters)
    : robot_(std::move(robot)), parameters_(parameters) {}

Output Procedure::step(const Input& input, State& state) const {
  Output output;
  ProcedureStep(robot_, parameters_, input, state, output).run();
  return output;
}

void ProcedureStep::run() {
  s_.numbers.observe(in_.servo.goal_id, in_.utime);
  if (in_.base) s_.drive.numbers.observe(in_.base->goal_id, in_.utime);
  watch_the_clock();
  watch_the_arm();
  watch_the_stop_devices();
  watch_the_hand();
  for (const Command& command : in_.commands) hear(command);
  watch_the_servo();
  insist_on_rest();
  if (under_way(s_.phase)) run_phase();
  // Not before its device is known: who reports before may be anyone, and the hand may hold something.
  if (s_.goal.id == 0 && in_.arm && in_.stop.known && robot_.arm) hold();
  command_the_base();

  const bool send_goal = s_.goal.id != 0 && (s_.goal_is_new || s_.repeat.due(in_.utime));
  if (send_goal) {
    s_.repeat.restart(in_.utime);
    s_.goal_is_new = false;
    out_.goal = s_.goal;
  }
  out_.phase = s_.phase;
  out_.attempt = s_.attempt;
  out_.result = s_.result;
  out_.target = s_.task.target;
  out_.reason = s_.reason;
  out_.command_session = s_.inbox.session();
  out_.command_id = s_.inbox.id();
}

// While no SERVO_STATUS came no goal was repeated: arm and base had to hold, and nobody is late by that time.
void ProcedureStep::pass_over(std::int64_t pause_us) {
  for (std::int64_t* time : {&s_.since, &s_.seen_utime, &s_.move_progress.since, &s_.drive.progress.since,
                             &s_.drive.progress.answered, &s_.drive.progress.driving}) {
    *time += pause_us;
  }
  for (auto* time : {&s_.lost_since, &s_.stale_since, &s_.stopped_since, &s_.unheard_since, &s_.move_progress.there}) {
    if (*time) **time += pause_us;
  }
  if (!under_way(s_.phase) || pause_us < kWorthAWord_us) return;
  char text[96];
  std::snprintf(text, sizeof text, "SERVO_STATUS left out %.1f s by its times: the task goes on from there",
                1e-6 * static_cast<double>(pause_us));
  out_.notices.emplace_back(text);
}

// All that is timed would wait for the old time to come again.
void ProcedureStep::watch_the_clock() {
  constexpr double kStep_s = 1.0;
  constexpr std::int64_t kGoalAge_us = 600'000;  // arm and base hold from then on
  const std::int64_t before = std::exchange(s_.utime, in_.utime);
  if (before != 0 && in_.utime - before > kGoalAge_us) pass_over(in_.utime - before - kGoalAge_us);
  if (seconds_between(in_.utime, before) <= kStep_s) return;
  s_.lost_since.reset();
  s_.stale_since.reset();
  s_.stopped_since.reset();
  s_.unheard_since.reset();
  s_.arm_unanswered_since.reset();
  s_.drive.unanswered_since.reset();
  if (under_way(s_.phase)) stop("the clock of SERVO_STATUS was set back");
}

void ProcedureStep::watch_the_arm() {
  if (!in_.arm) return;
  const bool restarted = s_.arm_session != 0 && s_.arm_session != in_.arm->session;
  s_.arm_session = in_.arm->session;
  if (!restarted) return;
  if (under_way(s_.phase) || s_.phase == Phase::kHoldLifted) {
    stop("the arm restarted");
  } else if (s_.goal.id != 0) {
    hold();  // what the arm was told in its former life is not its state any more
  }
}

void ProcedureStep::watch_the_stop_devices() {
  const bool known_before = std::exchange(s_.stop_was_known, in_.stop.known);
  const bool latched_before = std::exchange(s_.stop_was_latched, in_.stop.latched);
  // The first word of a stop device may tell of a stop that is reset by now: a task that waited for it goes on.
  const bool first_word = !known_before && waits_for_first_word();
  const bool stopped = in_.stop.latched || (in_.stop.meanwhile && !first_word);
  if (!in_.stop.known && known_before && under_way(s_.phase) && s_.phase != Phase::kLook && !waits_for_first_word()) {
    stop("a stop device is silent: no STOP_STATE of " + in_.stop.silent);
  }
  if (stopped && (under_way(s_.phase) || s_.phase == Phase::kHoldLifted)) {
    if (first_word) {
      refuse("stop is latched: reset it first (" + in_.stop.reason + ")");
    } else {
      stop("stop: " + (in_.stop.latched ? in_.stop.reason : "it is reset by now"));
    }
  }
  // Movers obey no goal from before the reset: without a new one the gripper would be told nothing.
  if ((latched_before || in_.stop.meanwhile) && !in_.stop.latched && s_.goal.id != 0) hold();
}

// Whoever took the floor before us, an earlier run of ours perhaps, may have fallen silent by now: only a new goal is
// heard then.
void ProcedureStep::insist_on_rest() {
  constexpr double kUnanswered_s = 1.0;
  const auto unanswered = [&](bool now, std::optional<std::int64_t>& since) {
    if (!now) since.reset();
    if (now && !since) since = in_.utime;
    if (!now || seconds_between(*since, in_.utime) <= kUnanswered_s) return false;
    since.reset();
    return true;
  };
  const bool resting = !under_way(s_.phase) && !in_.stop.latched;
  const auto ignored = [](const auto& report, std::int64_t id) {
    return report.goal_id != id && !report.follows_another;
  };
  if (unanswered(resting && s_.goal.id != 0 && ignored(in_.servo, s_.goal.id), s_.arm_unanswered_since)) send(s_.goal);
  const bool base_rests = resting && !s_.drive.goal.drive && s_.drive.goal.id != 0;
  if (unanswered(base_rests && in_.base && ignored(*in_.base, s_.drive.goal.id), s_.drive.unanswered_since))
    send(s_.drive.goal);
}

void ProcedureStep::watch_the_servo() {
  const auto lasts = [&](bool now, std::optional<std::int64_t>& since) {
    if (!now) since.reset();
    if (now && !since) since = in_.utime;
    return now && seconds_between(*since, in_.utime) > p_.motion.stale_timeout;
  };
  const bool moving = under_way(s_.phase) && s_.phase != Phase::kLook;
  if (lasts(moving && in_.servo.state == ServoState::kStale, s_.stale_since)) {
    fail("the arm holds for want of fresh input: " + in_.servo.reason);
  }
  if (lasts(moving && in_.servo.state == ServoState::kStopped, s_.stopped_since)) {
    stop("visual-servo is stopped: " + in_.servo.reason);
  }
  const bool unheard = moving && s_.goal.id != 0 && in_.servo.goal_id != s_.goal.id;
  if (lasts(unheard, s_.unheard_since)) {
    fail("visual-servo does not answer the goal" + (in_.servo.reason.empty() ? "" : ": " + in_.servo.reason));
  }
}

// A reset simulator or a person may have taken the object away while nothing was under way.
void ProcedureStep::watch_the_hand() {
  if (!s_.holding.something || !in_.arm) return;
  if (under_way(s_.phase)) {
    s_.holding.q = in_.arm->q;
    return;
  }
  constexpr double kElsewhere = 0.2;  // rad: more than an arm coasts after a stop
  if (in_.arm->session != s_.holding.arm_session || (in_.arm->q - s_.holding.q).cwiseAbs().maxCoeff() > kElsewhere ||
      in_.arm->gripper_opening > target().grip->object_width + kOpened) {
    s_.holding.something = false;
    const std::string what = "the hand does not hold " + s_.task.target + " any more";
    out_.notices.push_back(what);
    // Nothing is left to be held up: the arm stays where it is now.
    if (s_.phase == Phase::kHoldLifted) stop(what);
  }
}

void ProcedureStep::hear(const Command& command) {
  const motion::CommandStamp stamp{command.session, command.id, command.utime};
  switch (s_.inbox.hear(stamp, in_.now, command.kind == CommandKind::kAbort)) {
    case motion::CommandHeard::kExecute:
      execute(command);
      break;
    case motion::CommandHeard::kStale:
      out_.notices.push_back(std::string(command.kind == CommandKind::kStart ? "START" : "HOME") +
                             " refused: " + s_.inbox.why_stale(stamp, in_.now));
      break;
    case motion::CommandHeard::kAgain:
      // A sender that counts badly is to be obeyed all the same.
      if (command.kind == CommandKind::kAbort && under_way(s_.phase)) execute(command);
      break;
  }
}

void ProcedureStep::execute(const Command& command) {
  switch (command.kind) {
    case CommandKind::kStart:
      start(command);
      break;
    case CommandKind::kHome:
      home();
      break;
    case CommandKind::kAbort:
      if (under_way(s_.phase)) {
        stop("aborted by operator");
      } else {
        out_.notices.emplace_back("nothing to abort");
      }
      break;
  }
}

std::string ProcedureStep::why_no_task(const Command& command) const {
  if (!robot_.arm) return "the robot has no arm: its description has no section 'arm'";
  if (hand_mark_of(robot_) == nullptr) return "the robot's description has no mark of role manipulator";
  const robot::MarkDescription* mark = robot_.find_mark(command.target);
  if (mark == nullptr || mark->role != robot::MarkRole::kTarget) {
    std::string known;
    for (const auto& other : robot_.marks) {
      if (other.role == robot::MarkRole::kTarget) known += (known.empty() ? "" : ", ") + other.name;
    }
    return "unknown target '" + command.target + "'; the robot's description has: " + known;
  }
  if (!mark->grip) return "the description of " + command.target + " has no section 'grip': it cannot be taken";
  if (command.drive_pose && !robot_.base) return "the robot cannot drive: its description has no section 'base'";
  if (in_.stop.latched) return "stop is latched: reset it first (" + in_.stop.reason + ")";
  if (s_.holding.something) return "the hand holds " + s_.task.target + ": send HOME first, which puts it back";
  return "";
}

void ProcedureStep::start(const Command& command) {
  if (under_way(s_.phase)) {
    out_.notices.push_back("START of '" + command.target + "' ignored: " + s_.task.target + " is under way (" +
                           name_of(s_.phase) + "); abort it first");
    return;
  }
  const std::string why = why_no_task(command);
  if (s_.holding.something && !why.empty()) {
    // What is held decides what HOME does: the task stays as it is.
    out_.notices.push_back("START of '" + command.target + "' refused: " + why);
    s_.result = Result::kRefused;
    s_.phase = Phase::kRefused;
    s_.reason = why;
    return;
  }
  s_.task = command;
  s_.attempt = 1;
  s_.result = Result::kNone;
  s_.drive.driven = false;
  s_.drive.corrections = 0;
  if (!why.empty()) return refuse(why);
  if (command.drive_pose) return enter(Phase::kDrive, "making ready to drive");
  s_.target_mean = MarkAverage();
  enter(Phase::kLook, "looking for the mark of " + command.target);
}

void ProcedureStep::home() {
  if (under_way(s_.phase)) {
    out_.notices.push_back(std::string("HOME ignored: a task is under way (") + name_of(s_.phase) +
                           "); abort it first");
    return;
  }
  if (!robot_.arm) return stop("home: the robot has no arm");
  if (in_.stop.latched) return stop("stop is latched: reset it first (" + in_.stop.reason + ")");
  if (!in_.stop.known) return stop("home: not every stop device answers: no STOP_STATE of " + in_.stop.silent);
  if (!in_.arm) return stop("home: the arm does not answer (no JOINT_STATE)");
  if (s_.holding.something && !s_.holding.over_place) {
    return stop("home: the hand holds " + s_.task.target + " away from its place; take it out of the hand first");
  }
  if (s_.holding.something) {
    const PosturePath path =
        plan_put_back(arm(), p_, in_.arm->q, robot::grip_point(arm(), s_.before.q), s_.p_CG_first, closed_opening());
    if (!path.reachable()) return fail(std::string("cannot put it back: ") + robot::describe(path.status()));
    s_.after_release = AfterRelease::kHome;
    enter(Phase::kRelease, "putting " + s_.task.target + " back");
    return play(path.moves());
  }
  const PosturePath path = plan_home(arm(), p_, {in_.arm->q, in_.arm->gripper_opening});
  if (!path.reachable()) return fail(std::string("no way home: ") + robot::describe(path.status()));
  s_.after_release = AfterRelease::kHome;
  enter(Phase::kGoHome, "on the way home");
  play(path.moves());
}

void ProcedureStep::enter(Phase phase, const std::string& reason) {
  s_.phase = phase;
  s_.lost_since.reset();
  enter_stage(0, reason);
}

void ProcedureStep::enter_stage(int stage, const std::string& reason) {
  s_.stage = stage;
  s_.since = in_.utime;
  s_.seen_utime = in_.utime;
  s_.reason = reason;
}

void ProcedureStep::refuse(const std::string& reason) {
  s_.result = Result::kRefused;
  enter(Phase::kRefused, reason);
}

void ProcedureStep::fail(const std::string& reason) {
  s_.result = Result::kFailed;
  enter(Phase::kFailed, reason);
  hold();
}

void ProcedureStep::stop(const std::string& reason) {
  // What is lifted stays lifted; a task that was under way did not succeed.
  if (under_way(s_.phase) && s_.result == Result::kNone) s_.result = Result::kFailed;
  enter(Phase::kStopped, reason);
  if (robot_.arm) hold();
}

void ProcedureStep::send(Goal goal) {
  goal.id = s_.numbers.next(s_.goal.id);
  s_.goal = std::move(goal);
  s_.goal_is_new = true;
}

void ProcedureStep::hold() {
  Goal goal;
  goal.kind = GoalKind::kHold;
  goal.force = std::min(p_.grip.force, arm().gripper.force_max);
  if (s_.goal.id != 0) {
    goal.opening = s_.goal.opening;
    if (holds_something()) {
      goal.opening = closed_opening();
    } else if (in_.arm) {
      goal.opening = std::clamp(in_.arm->gripper_opening, 0.0, arm().gripper.opening_max);
    }
  } else if (in_.arm) {
    // After a restart: what is not open may be closed around something.
    const double open = arm().gripper.opening_max;
    goal.opening = in_.arm->gripper_opening < open - p_.grip.open_enough ? 0.0 : open;
  } else {
    return;  // nothing is known that could be kept
  }
  send(goal);
}

// As far as the arm's report does not speak against it.
bool ProcedureStep::holds_something() const {
  if (!s_.holding.something || s_.holding.let_go) return false;
  return !in_.arm || (in_.arm->session == s_.holding.arm_session &&
                      in_.arm->gripper_opening <= target().grip->object_width + kOpened);
}

void ProcedureStep::play(const std::vector<Move>& moves) {
  s_.moves = moves;
  s_.move_index = 0;
  if (!moves.empty()) send_move();
}

void ProcedureStep::send_move() {
  const Move& move = s_.moves[s_.move_index];
  s_.move_progress = MoveProgress();
  s_.move_progress.since = in_.utime;
  Goal goal;
  goal.kind = move.hold ? GoalKind::kHold : GoalKind::kPosture;
  goal.q = move.q;
  goal.speed = move.speed;
  goal.opening = move.opening;
  goal.force = std::min(p_.grip.force, arm().gripper.force_max);
  if (s_.holding.something) s_.holding.let_go = move.opening > target().grip->object_width;
  send(goal);
}

// Goes on along the way; true when its end is reached. A failure ends the task.
bool ProcedureStep::way_is_done() {
  if (s_.move_index >= s_.moves.size()) return true;
  const MoveReport report = watch_move(s_.moves[s_.move_index], s_.goal.id, in_, p_.motion, s_.move_progress);
  if (report.state == MoveState::kFailed) fail(report.reason);
  if (report.state != MoveState::kDone) return false;
  if (++s_.move_index == s_.moves.size()) return true;
  send_move();
  return false;
}

double ProcedureStep::closed_opening() const {
  return std::max(0.0, target().grip->object_width - p_.grip.squeeze);
}

MarkReport ProcedureStep::sight_of(const std::string& name) const {
  for (const MarkReport& mark : in_.marks) {
    if (mark.name == name) return mark;
  }
  return {name, std::nullopt, Eigen::Vector3d::Zero()};
}

}  // namespace markservo::task_manager
