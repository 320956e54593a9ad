#pragma once

// What the base does not drive by: inputs that are old, and a pose that is not known well enough.

#include <optional>
#include <string>

#include "common/geometry/plane_pose.hpp"
#include "services/base-navigator/drive/exploration.hpp"
#include "services/base-navigator/kinematics/odometry_track.hpp"
#include "services/base-navigator/navigator_types.hpp"
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

// Each gives a reason, empty when nothing speaks against what is asked of.

// Why a goal of `utime` (us) is too old or too far ahead by the newest odometry.
std::string why_goal_is_stale(const TrustParameters& trust, std::int64_t utime, const OdometryTrack& track);

// Why what is known of wheels, pose or sonars is too old.
std::string why_stale(const TrustParameters& trust, const OdometryTrack& track, const std::optional<PoseSample>& pose,
                      const SonarMemory& sonars);

// Why the base cannot drive by the pose, nor learn its heading, in which it may have failed before.
std::string why_lost(const TrustParameters& trust, const ExploreParameters& explore, const PoseSample& pose,
                     bool exploration_failed);

// Dead reckoning: X_WR of the pose, carried on to now by the wheels. Requires that it is not stale.
geometry::PlanePose reckoned_pose(const TrustParameters& trust, const PoseSample& pose, const OdometryTrack& track);

}  // namespace markservo::base_navigator
