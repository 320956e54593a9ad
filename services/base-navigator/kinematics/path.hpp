#pragma once

// A path of the robot as poses along it; straight ones and turns on the spot.

#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "services/base-navigator/kinematics/outline.hpp"

namespace markservo::base_navigator {

// One pose on the path.
struct PathPose {
  geometry::PlanePose X_RS;  // from where the robot is now
  double length = 0.0;       // m, of the path up to here; the first is 0, each greater than the one before
};

enum class Direction { kForward = 1, kBackward = -1 };

inline double sign_of(Direction direction) {
  return direction == Direction::kForward ? 1.0 : -1.0;
}

// A path straight on, forward or backward, for `length` m; poses are at most `step` m apart.
std::vector<PathPose> straight_path(Direction direction, double step, double length);

// A turn on the spot by `angle` (rad, counter-clockwise). Lengths are those that the outline's farthest corner goes.
std::vector<PathPose> turning_path(const Outline& outline, double angle, double step);

}  // namespace markservo::base_navigator
