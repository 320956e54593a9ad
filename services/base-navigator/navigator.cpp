#include "services/base-navigator/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "common/motion/freshness.hpp"

namespace markservo::base_navigator {
namespace {

using geometry::PlanePose;

constexpr double kNominalStep_s = 0.02;
constexpr double kShortestStep_s = 0.005;
constexpr double kLongestStep_s = 0.1;  // a longer gap must not become a bigger step

const robot::BaseDescription& base_of(const robot::RobotDescription& robot) {
  if (!robot.base) throw std::invalid_argument("base-navigator: robot.yaml has no base");
  if (!robot.sonars) throw std::invalid_argument("base-navigator: robot.yaml has no sonars; it does not drive blindly");
  return *robot.base;
}

Outline outline_of(const robot::BaseDescription& base) {
  return {base.front, base.rear, base.half_width};
}

NavigatorParameters within_limits(NavigatorParameters parameters, const robot::BaseDescription& base) {
  MotionParameters& motion = parameters.manoeuvre.motion;
  motion.speed = std::min(motion.speed, base.speed_max);
  motion.turn_rate = std::min(motion.turn_rate, base.turn_rate_max);
  motion.acceleration = std::min(motion.acceleration, base.acceleration_max);
  motion.turn_acceleration = std::min(motion.turn_acceleration, base.turn_acceleration_max);
  motion.braking = base.acceleration_max;
  motion.turn_braking = base.turn_acceleration_max;
  parameters.explore.speed = std::min(parameters.explore.speed, motion.speed);
  parameters.odometry.track = base.track;
  parameters.odometry.wheel_speed = base.speed_max + 0.5 * base.track * base.turn_rate_max;
  return parameters;
}

// Empty unless `utime` is too far from now.
std::string why_old(const char* what, std::int64_t utime, std::int64_t now, double allowed) {
  return motion::why_not_fresh({what, "WHEEL_ODOMETRY", allowed, allowed}, utime, now);
}

}  // namespace

Navigator::Navigator(const robot::RobotDescription& robot, const NavigatorParameters& parameters)
    : parameters_(within_limits(parameters, base_of(robot))),
      scan_check_(*robot.sonars),
      guard_(outline_of(base_of(robot)), parameters_.manoeuvre.motion, parameters_.manoeuvre.passage),
      manoeuvre_(guard_, parameters_.manoeuvre) {}

std::string Navigator::observe(const OdometrySample& sample, NavigatorState& state) const {
  const bool first = state.track.empty();
  std::string problem = state.track.add(parameters_.odometry, sample);
  // A goal that came before any time did is judged now, so that none waits for its hour.
  if (first && !state.track.empty() &&
      state.goals.end_unless_fresh(state.track.newest_utime(), parameters_.trust.goal_age)) {
    state.dropped = "the goal heard before the first WHEEL_ODOMETRY is of another time: it was dropped";
    state.goal.reset();
  }
  return problem;
}

void Navigator::begin_anew(const std::string& why, NavigatorState& state) const {
  state.track.forget();
  state.pose.reset();
  if (state.goal) state.dropped = why + ": the goal was dropped";
  state.goals.end();
  state.goal.reset();
}

void Navigator::observe(const PoseSample& sample, NavigatorState& state) const {
  state.pose = sample;
}

std::string Navigator::observe(const SonarScanSample& scan, NavigatorState& state) const {
  std::string problem = scan_check_.why_refused(scan);
  if (problem.empty()) state.sonars.add(parameters_.sonars, scan, state.track);
  return problem;
}

motion::GoalHeard Navigator::observe(const Goal& goal, NavigatorState& state) const {
  const auto heard = state.goals.hear({goal.session, goal.id, goal.utime}, state.track.newest_utime(),
                                      parameters_.trust.goal_age, state.stop_latched.value_or(false));
  if (!state.goals.goal()) state.goal.reset();
  if (heard == motion::GoalHeard::kAgain) state.goal->utime = state.goals.goal()->utime;
  if (heard != motion::GoalHeard::kNew) return heard;
  state.goal = goal;
  state.refusal = why_goal_is_refused(goal, state);
  state.dropped.clear();
  state.manoeuvre = ManoeuvreState();
  state.exploration.permit();
  state.X_WG.reset();
  state.X_OG.reset();
  if (goal.kind == GoalKind::kDrive && goal.frame == GoalFrame::kWorld) state.X_WG = goal.pose;
  if (goal.kind == GoalKind::kDrive && goal.frame == GoalFrame::kRobot) {
    state.X_OG = state.track.newest() * goal.pose;
    state.X_OG_epoch = state.track.epoch();
  }
  return heard;
}

void Navigator::observe_stop(bool latched, const std::string& reason, NavigatorState& state) const {
  state.stop_latched = latched;
  state.stop_reason = reason;
  if (!latched) return;
  state.goals.end();
  state.goal.reset();
}

Output Navigator::step(NavigatorState& state) const {
  Output output;
  if (const auto& goal = state.goal) {
    output.status.goal_session = goal->session;
    output.status.goal_id = goal->id;
  }
  const Decision decision = decide(state, output.status);
  output.status.state = decision.advice.state;
  output.status.reason = decision.advice.reason;
  if (decision.at_once) {
    state.command = Command();
  } else {
    const double seconds = state.track.step() > 0.0 ? state.track.step() : kNominalStep_s;
    const Command measured{state.track.speed(), state.track.turn_rate()};
    state.command = next_command(parameters_.manoeuvre.motion, decision.advice.motion, state.command, measured,
                                 std::clamp(seconds, kShortestStep_s, kLongestStep_s));
  }
  output.command = state.command;
  return output;
}

Navigator::Decision Navigator::decide(NavigatorState& state, Status& status) const {
  const auto interrupted = [&state](const Motion& motion, DriveState drive_state, const std::string& reason,
                                    bool at_once) {
    Manoeuvre::interrupt(state.manoeuvre);
    state.exploration.interrupt();
    return Decision{{motion, drive_state, reason}, at_once};
  };
  const std::int64_t now = state.track.newest_utime();
  if (!state.blocked.empty()) return interrupted(stand(), DriveState::kStopped, state.blocked, true);
  if (!state.stop_latched || *state.stop_latched) {
    std::string reason = !state.stop_latched ? "no STOP_STATE of the base yet" : state.stop_reason;
    if (reason.empty()) reason = "STOP is latched";
    return interrupted(stand(), DriveState::kStopped, reason, true);
  }
  const auto& goal = state.goal;
  if (!goal) {
    return interrupted(stand(), DriveState::kHold, state.dropped.empty() ? "no goal" : state.dropped, false);
  }
  if (const auto why = why_old("BASE_GOAL", goal->utime, now, parameters_.trust.goal_age); !why.empty()) {
    return interrupted(stand(), DriveState::kStale, why, true);
  }
  if (!state.refusal.empty()) return interrupted(brake(), DriveState::kHold, state.refusal, false);
  if (goal->kind == GoalKind::kHold) return interrupted(stand(), DriveState::kHold, "", false);
  if (const auto why = why_stale(state); !why.empty()) return interrupted(stand(), DriveState::kStale, why, true);
  if (const auto why = why_lost(state); !why.empty()) return interrupted(brake(), DriveState::kLost, why, false);

  Situation situation;
  situation.utime = now;
  situation.X_OR = state.track.newest();
  situation.epoch = state.track.epoch();
  situation.X_WR = pose_now(state);
  situation.position_sigma = state.pose->position_sigma;
  situation.heading_sigma = state.pose->heading_sigma;
  situation.measured = {state.track.speed(), state.track.turn_rate()};
  const PassageParameters& passage = parameters_.manoeuvre.passage;
  const double clearance = goal->clearance > 0.0 ? goal->clearance : passage.clearance;
  // A turn on the spot keeps no more than its own clearance, so faces may hide no more than that.
  situation.points = state.sonars.points(parameters_.sonars, state.track, std::min(clearance, passage.turn_clearance));
  const double heading_sigma = parameters_.trust.heading_sigma;
  if (const auto advice = state.exploration.step(parameters_.explore, heading_sigma, guard_, situation, clearance)) {
    return {*advice, false};
  }

  if (!state.X_WG && !place_goal(state)) return interrupted(brake(), DriveState::kHold, state.refusal, false);
  const PlanePose X_RG = situation.X_WR.inverse() * *state.X_WG;
  status.distance = X_RG.distance();
  status.heading_error = X_RG.heading;
  if (status.distance > parameters_.trust.goal_distance) {
    char text[160];
    std::snprintf(text, sizeof text, "the goal is %.0f m away; allowed: %.0f m", status.distance,
                  parameters_.trust.goal_distance);
    return interrupted(brake(), DriveState::kHold, text, false);
  }
  const double own = parameters_.manoeuvre.motion.speed;
  const Assignment assignment{*state.X_WG, clearance, goal->speed > 0.0 ? std::min(goal->speed, own) : own};
  return {manoeuvre_.step(situation, assignment, state.manoeuvre), false};
}

std::string Navigator::why_goal_is_refused(const Goal& goal, const NavigatorState& state) const {
  if (goal.kind == GoalKind::kHold) return "";
  if (goal.clearance < 0.0) return "clearance is " + std::to_string(goal.clearance) + " m; allowed: 0 or more";
  if (goal.speed < 0.0) return "speed is " + std::to_string(goal.speed) + " m/s; allowed: 0 or more";
  if (goal.frame == GoalFrame::kWorld) return "";
  if (goal.pose.distance() > parameters_.trust.goal_distance) {
    return "the goal is " + std::to_string(goal.pose.distance()) +
           " m away; allowed: " + std::to_string(parameters_.trust.goal_distance) + " m";
  }
  // The run before may have driven a part of it; driving it once more would end elsewhere.
  const double age = seconds_between(state.track.first_utime(), state.track.newest_utime());
  if (state.track.empty() || age < std::max(parameters_.trust.restart_guard, parameters_.trust.goal_age)) {
    return "a goal relative to the robot was given before the navigator had started; allowed: a new goal_id";
  }
  return "";
}

std::string Navigator::why_stale(const NavigatorState& state) const {
  const std::int64_t now = state.track.newest_utime();
  if (state.track.empty()) return "no WHEEL_ODOMETRY yet";
  if (!state.track.problem().empty()) return "WHEEL_ODOMETRY: " + state.track.problem();
  if (!state.pose) return "no ROBOT_POSE yet";
  if (auto why = why_old("ROBOT_POSE", state.pose->utime, now, parameters_.trust.pose_age); !why.empty()) return why;
  if (!state.track.at(state.pose->utime, parameters_.trust.pose_age)) return "ROBOT_POSE is of before WHEEL_ODOMETRY";
  const std::int64_t scan = state.sonars.newest_utime(state.track);
  if (scan == 0) return "no SONAR_SCAN since WHEEL_ODOMETRY began";
  return why_old("SONAR_SCAN", scan, now, parameters_.trust.scan_age);
}

std::string Navigator::why_lost(const NavigatorState& state) const {
  const PoseSample& pose = *state.pose;
  const TrustParameters& trust = parameters_.trust;
  const ExploreParameters& explore = parameters_.explore;
  if (pose.state == Localisation::kLost) return "ROBOT_POSE is lost: " + pose.reason;
  const bool heading_known = pose.heading_sigma <= trust.heading_sigma;
  const bool may_explore = explore.enabled && !heading_known;
  if (pose.state == Localisation::kSearching && !may_explore) return "ROBOT_POSE is searching: " + pose.reason;
  const double allowed = may_explore ? explore.position_sigma : trust.position_sigma;
  char text[160];
  if (pose.position_sigma > allowed) {
    std::snprintf(text, sizeof text, "the position's sigma is %.2f m; allowed: %.2f m", pose.position_sigma, allowed);
    return text;
  }
  if (!heading_known && !may_explore) {
    std::snprintf(text, sizeof text, "the heading's sigma is %.2f rad; allowed: %.2f rad", pose.heading_sigma,
                  trust.heading_sigma);
    return text;
  }
  if (!heading_known && state.exploration.failed()) {
    std::snprintf(text, sizeof text, "the heading did not become known within %.2f m", explore.distance);
    return text;
  }
  return "";
}

// The newest pose, carried on to now by the wheels.
PlanePose Navigator::pose_now(const NavigatorState& state) const {
  const auto X_OR_then = state.track.at(state.pose->utime, parameters_.trust.pose_age);
  return state.pose->X_WR * (X_OR_then->inverse() * state.track.newest());
}

// A goal in R is kept in the wheels' frame until the pose is good enough to place it in W.
bool Navigator::place_goal(NavigatorState& state) const {
  if (!state.X_OG || state.X_OG_epoch != state.track.epoch()) {
    state.refusal = "WHEEL_ODOMETRY was interrupted before a goal relative to the robot could be placed";
    return false;
  }
  state.X_WG = pose_now(state) * (state.track.newest().inverse() * *state.X_OG);
  return true;
}

}  // namespace markservo::base_navigator
