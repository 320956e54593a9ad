#include "services/base-navigator/navigator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace markservo::base_navigator {
namespace {

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
  MotionParameters& motion = parameters.motion;
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

}  // namespace

Navigator::Navigator(const robot::RobotDescription& robot, const NavigatorParameters& parameters)
    : parameters_(within_limits(parameters, base_of(robot))),
      scan_check_(*robot.sonars),
      guard_(outline_of(base_of(robot)), parameters_.motion, parameters_.passage),
      manoeuvre_(guard_, parameters_.manoeuvre) {}

std::string Navigator::observe(const OdometrySample& sample, NavigatorState& state) const {
  const bool first = state.track.empty();
  std::string problem = state.track.add(parameters_.odometry, sample);
  if (first && !state.track.empty()) state.goal.end_unless_fresh(parameters_.trust, state.track);
  return problem;
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
  const auto heard = state.goal.observe(parameters_.trust, goal, state.track, state.enable.latched());
  if (heard != motion::GoalHeard::kNew) return heard;
  state.manoeuvre = ManoeuvreState();
  state.exploration.forget_failure();
  return heard;
}

void Navigator::observe_stop(bool latched, const std::string& reason, NavigatorState& state) const {
  state.enable.observe_stop(latched, reason);
  if (latched) state.goal.end();
}

void Navigator::begin_anew(const std::string& why, NavigatorState& state) const {
  state.track.forget();
  state.pose.reset();
  state.goal.drop(why);
}

Output Navigator::step(NavigatorState& state) const {
  Output output;
  if (const auto& goal = state.goal.goal()) {
    output.status.goal_session = goal->session;
    output.status.goal_id = goal->id;
  }
  const auto standing = pause_due(state);
  const Decision decision = standing ? *standing : drive(state, output.status);
  if (decision.pauses) {
    Manoeuvre::interrupt(state.manoeuvre);
    state.exploration.interrupt();
  }
  output.status.state = decision.advice.state;
  output.status.reason = decision.advice.reason;
  state.command = command(decision, state);
  output.command = state.command;
  return output;
}

Navigator::Decision Navigator::pause(const Motion& motion, DriveState state, const std::string& reason) {
  return {{motion, state, reason}, false, true};
}

Navigator::Decision Navigator::pause_at_once(DriveState state, const std::string& reason) {
  return {{stand(), state, reason}, true, true};
}

std::optional<Navigator::Decision> Navigator::pause_due(const NavigatorState& state) const {
  const TrustParameters& trust = parameters_.trust;
  if (const auto why = state.enable.why_stopped(); !why.empty()) return pause_at_once(DriveState::kStopped, why);
  const auto& goal = state.goal.goal();
  if (!goal) return pause(stand(), DriveState::kHold, state.goal.why_none());
  if (const auto why = why_goal_is_stale(trust, goal->utime, state.track); !why.empty()) {
    return pause_at_once(DriveState::kStale, why);
  }
  if (!state.goal.refusal().empty()) return pause(brake(), DriveState::kHold, state.goal.refusal());
  if (goal->kind == GoalKind::kHold) return pause(stand(), DriveState::kHold, "");
  if (const auto why = why_stale(trust, state.track, state.pose, state.sonars); !why.empty()) {
    return pause_at_once(DriveState::kStale, why);
  }
  if (const auto why = why_lost(trust, parameters_.explore, *state.pose, state.exploration.failed()); !why.empty()) {
    return pause(brake(), DriveState::kLost, why);
  }
  return std::nullopt;
}

Navigator::Decision Navigator::drive(NavigatorState& state, Status& status) const {
  const TrustParameters& trust = parameters_.trust;
  const Goal& goal = *state.goal.goal();
  const double clearance = goal.clearance > 0.0 ? goal.clearance : parameters_.passage.clearance;
  const Situation now = situation(state, clearance);
  if (const auto advice = state.exploration.step(parameters_.explore, trust.heading_sigma, guard_, now, clearance)) {
    return {*advice};
  }
  const auto X_WG = state.goal.place(now.X_WR, state.track);
  if (!X_WG) return pause(brake(), DriveState::kHold, state.goal.refusal());
  const PoseError error = error_of(now.X_WR, *X_WG);
  status.distance = error.distance;
  status.heading_error = error.heading;
  if (error.distance > trust.goal_distance) {
    return pause(brake(), DriveState::kHold,
                 fmt::format("the goal is {:.0f} m away; allowed: {:.0f} m", error.distance, trust.goal_distance));
  }
  const double own = parameters_.motion.speed;
  const Assignment assignment{*X_WG, clearance, goal.speed > 0.0 ? std::min(goal.speed, own) : own};
  return {manoeuvre_.step(now, assignment, state.manoeuvre)};
}

Situation Navigator::situation(const NavigatorState& state, double clearance) const {
  Situation now;
  now.utime = state.track.newest_utime();
  now.X_OR = state.track.newest();
  now.epoch = state.track.epoch();
  now.X_WR = reckoned_pose(parameters_.trust, *state.pose, state.track);
  now.position_sigma = state.pose->position_sigma;
  now.heading_sigma = state.pose->heading_sigma;
  now.measured = {state.track.speed(), state.track.turn_rate()};
  // A turn on the spot keeps no more than its own clearance, so faces may hide no more than that.
  const double kept = std::min(clearance, parameters_.passage.turn_clearance);
  now.points = state.sonars.points(parameters_.sonars, state.track, kept);
  return now;
}

Command Navigator::command(const Decision& decision, const NavigatorState& state) const {
  if (decision.at_once) return {};
  const double seconds = state.track.step() > 0.0 ? state.track.step() : kNominalStep_s;
  const Command measured{state.track.speed(), state.track.turn_rate()};
  return next_command(parameters_.motion, decision.advice.motion, state.command, measured,
                      std::clamp(seconds, kShortestStep_s, kLongestStep_s));
}

}  // namespace markservo::base_navigator
