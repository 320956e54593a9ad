#pragma once

// Drives the base to a goal pose, or says why not.

#include <cstdint>
#include <optional>
#include <string>

#include "common/motion/goal_inbox.hpp"
#include "common/robot/robot_description.hpp"
#include "services/base-navigator/drive/exploration.hpp"
#include "services/base-navigator/drive/manoeuvre.hpp"
#include "services/base-navigator/drive/path_guard.hpp"
#include "services/base-navigator/kinematics/odometry_track.hpp"
#include "services/base-navigator/navigator_types.hpp"
#include "services/base-navigator/obstacles/scan_check.hpp"
#include "services/base-navigator/obstacles/sonar_memory.hpp"

namespace markservo::base_navigator {

struct TrustParameters {
  double pose_age = 0.2;         // s; it stands when ROBOT_POSE is older than WHEEL_ODOMETRY by more
  double scan_age = 0.25;        // s; likewise SONAR_SCAN: two rounds of 0.1 s and a late one
  double goal_age = 0.6;         // s; goals are repeated at 0.2 s
  double position_sigma = 0.10;  // m, of a pose to drive by
  double heading_sigma = 0.3;    // rad, likewise; above it the heading is learnt first
  double goal_distance = 100.0;  // m; a goal farther from the robot is a mistake
  // s after the start in which a goal in R is one that was given to a run before; never taken as less than goal_age,
  // within which such a goal counts as repeated though repetitions were lost.
  double restart_guard = 0.6;
};

struct NavigatorParameters {
  ManoeuvreParameters manoeuvre;
  TrustParameters trust;
  ExploreParameters explore;
  OdometryParameters odometry;
  SonarMemoryParameters sonars;
};

struct NavigatorState {
  OdometryTrack track;
  SonarMemory sonars;
  std::optional<PoseSample> pose;
  motion::GoalInbox goals{"BASE_GOAL"};
  std::optional<Goal> goal;                 // what goals.goal() asks for
  std::string refusal;                      // why the goal is not followed
  std::string dropped;                      // why the last goal was dropped, until the next one
  std::optional<geometry::PlanePose> X_WG;  // DRIVE, once known
  std::optional<geometry::PlanePose> X_OG;  // DRIVE in R, until X_WG is known
  int X_OG_epoch = 0;
  std::optional<bool> stop_latched;
  std::string stop_reason;
  std::string blocked;  // why nothing may move though no stop is latched; empty when nothing speaks against it
  ManoeuvreState manoeuvre;
  Exploration exploration;
  Command command;  // the last one
};

// observe() what comes in, then step() once for each WHEEL_ODOMETRY; now is the newest odometry's utime. What is wrong
// with an input is returned as a text (empty: nothing), for the caller to count; the base does not move by it.
class Navigator {
 public:
  // Limits of the base's own in `robot` lower those of the parameters. Throws std::invalid_argument if the robot has no
  // base or no sonars.
  Navigator(const robot::RobotDescription& robot, const NavigatorParameters& parameters);

  std::string observe(const OdometrySample& sample, NavigatorState& state) const;
  void observe(const PoseSample& sample, NavigatorState& state) const;
  std::string observe(const SonarScanSample& scan, NavigatorState& state) const;
  // What became of a goal, new or repeated; of a new one state.refusal says why it is not followed.
  motion::GoalHeard observe(const Goal& goal, NavigatorState& state) const;
  void observe_stop(bool latched, const std::string& reason, NavigatorState& state) const;
  // The base is another one, or its clock began anew: the way so far and a goal of the former time are forgotten. `why`
  // for people.
  void begin_anew(const std::string& why, NavigatorState& state) const;

  Output step(NavigatorState& state) const;

  const NavigatorParameters& parameters() const { return parameters_; }

 private:
  struct Decision {
    Advice advice;
    bool at_once = false;  // not ramped: the base brakes as hard as it can
  };

  Decision decide(NavigatorState& state, Status& status) const;
  std::string why_goal_is_refused(const Goal& goal, const NavigatorState& state) const;
  std::string why_stale(const NavigatorState& state) const;
  std::string why_lost(const NavigatorState& state) const;
  geometry::PlanePose pose_now(const NavigatorState& state) const;
  bool place_goal(NavigatorState& state) const;

  NavigatorParameters parameters_;
  ScanCheck scan_check_;
  PathGuard guard_;
  Manoeuvre manoeuvre_;
};

}  // namespace markservo::base_navigator
