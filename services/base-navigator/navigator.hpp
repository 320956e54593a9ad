#pragma once

// Drives the base to a goal pose, or says why not.

#include <optional>
#include <string>

#include "common/motion/goal_inbox.hpp"
#include "common/robot/robot_description.hpp"
#include "services/base-navigator/drive/exploration.hpp"
#include "services/base-navigator/drive/manoeuvre.hpp"
#include "services/base-navigator/drive/path_guard.hpp"
#include "services/base-navigator/inputs/followed_goal.hpp"
#include "services/base-navigator/inputs/motion_enable.hpp"
#include "services/base-navigator/inputs/trust.hpp"
#include "services/base-navigator/kinematics/motion.hpp"
#include "services/base-navigator/kinematics/odometry_track.hpp"
#include "services/base-navigator/navigator_types.hpp"
#include "services/base-navigator/obstacles/passage.hpp"
#include "services/base-navigator/obstacles/scan_check.hpp"
#include "services/base-navigator/obstacles/sonar_memory.hpp"

namespace markservo::base_navigator {

struct NavigatorParameters {
  MotionParameters motion;
  PassageParameters passage;
  ManoeuvreParameters manoeuvre;
  TrustParameters trust;
  ExploreParameters explore;
  OdometryParameters odometry;
  SonarMemoryParameters sonars;
};

struct NavigatorState {
  MotionEnable enable;
  OdometryTrack track;
  SonarMemory sonars;
  std::optional<PoseSample> pose;
  FollowedGoal goal;
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
  // What became of a goal, new or repeated; of a new one state.goal.refusal() says why it is not followed.
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
    bool pauses = false;   // what was under way is interrupted
  };

  static Decision pause(const Motion& motion, DriveState state, const std::string& reason);
  static Decision pause_at_once(DriveState state, const std::string& reason);
  // What forbids to drive; nothing when it may.
  std::optional<Decision> pause_due(const NavigatorState& state) const;
  Decision drive(NavigatorState& state, Status& status) const;
  Situation situation(const NavigatorState& state, double clearance) const;
  Command command(const Decision& decision, const NavigatorState& state) const;

  NavigatorParameters parameters_;
  ScanCheck scan_check_;
  PathGuard guard_;
  Manoeuvre manoeuvre_;
};

}  // namespace markservo::base_navigator
