#pragma once

// How far the robot's outline can follow a path before it comes too near to what the sonars have seen.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "services/base-navigator/kinematics/outline.hpp"
#include "services/base-navigator/kinematics/path.hpp"

namespace markservo::base_navigator {

// A place where something may be.
struct SeenPoint {
  Eigen::Vector2d p_R = Eigen::Vector2d::Zero();  // m
  double blind_range = 0.0;  // m: the echo was too near to be measured, so that much before the point may be filled too
};

struct FreePath {
  double length = 0.0;    // m of the path that can be gone
  bool limited = false;   // false: the whole path can
  double distance = 0.0;  // m, from the outline as it is now to what limits the path
  double bearing = 0.0;   // rad, its direction in R
};

// The part of `path` on which the outline stays `clearance` (m, 0 or more) away from every point. What is nearer than
// that already forbids only paths that lead closer to it, anywhere on them, by more than the sonars' noise.
FreePath free_path(const Outline& outline, double clearance, const std::vector<SeenPoint>& points,
                   const std::vector<PathPose>& path);

// "ahead", "ahead on the left", ...: for people.
std::string side_of(double bearing);

}  // namespace markservo::base_navigator
