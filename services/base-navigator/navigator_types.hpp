#pragma once

// What the navigator is told and what it answers: plain structs behind the messages of lcmtypes. SI units, rad; frames
// W world, R robot, S sonar, G goal; utime in us of measurement.

#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "common/states/base_state.hpp"
#include "common/states/localisation_state.hpp"
#include "common/time/seconds_between.hpp"

namespace markservo::base_navigator {

// One WHEEL_ODOMETRY.
struct OdometrySample {
  std::int64_t utime = 0;
  double left = 0.0;  // m that the wheel went since the driver started
  double right = 0.0;
};

using Localisation = LocalisationState;

// One ROBOT_POSE.
struct PoseSample {
  std::int64_t utime = 0;
  Localisation state = Localisation::kSearching;
  geometry::PlanePose X_WR;
  double position_sigma = 0.0;  // m, along the worst axis
  double heading_sigma = 0.0;   // rad
  std::string reason;           // why it is searching or lost
};

struct SonarReading {
  geometry::PlanePose X_RS;  // x is the beam's middle
  bool heard = false;
  double range = 0.0;  // m from the sonar
};

// One SONAR_SCAN.
struct SonarScanSample {
  std::int64_t utime = 0;
  double min_range = 0.0;   // m
  double max_range = 0.0;   // m
  double beam_width = 0.0;  // rad, full cone
  std::vector<SonarReading> readings;
};

enum class GoalKind { kHold, kDrive };
enum class GoalFrame { kWorld, kRobot };

// One BASE_GOAL.
struct Goal {
  std::int64_t utime = 0;
  std::int64_t session = 0;
  std::int64_t id = 0;
  GoalKind kind = GoalKind::kHold;
  GoalFrame frame = GoalFrame::kWorld;
  geometry::PlanePose pose;  // X_WG, or X_RG at first hearing
  double clearance = 0.0;    // m; 0: the parameters' own
  double speed = 0.0;        // m/s; 0: the parameters' own
};

using DriveState = BaseState;

// One BASE_COMMAND.
struct Command {
  double speed = 0.0;      // m/s, forward
  double turn_rate = 0.0;  // rad/s, counter-clockwise
};

// One BASE_STATUS.
struct Status {
  DriveState state = DriveState::kHold;
  double distance = 0.0;       // m, to the goal; 0 while that is unknown
  double heading_error = 0.0;  // rad, goal minus robot; 0 while that is unknown
  std::string reason;          // why it cannot go on
  std::int64_t goal_session = 0;
  std::int64_t goal_id = 0;
};

// What answers one WHEEL_ODOMETRY.
struct Output {
  Command command;
  Status status;
};

}  // namespace markservo::base_navigator
