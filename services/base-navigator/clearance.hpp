#pragma once

// How far the robot's outline can follow a path before it comes too near to what the sonars have seen.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "common/geometry/plane_pose.hpp"

namespace markservo::base_navigator {

// The robot from above, in R: -rear <= x <= front, |y| <= half_width; m.
struct Outline {
  double front = 0.0;
  double rear = 0.0;
  double half_width = 0.0;

  // m, from R's origin to the farthest corner: what a turn on the spot sweeps.
  double reach() const;
};

// A place where something may be.
struct SeenPoint {
  Eigen::Vector2d p_R = Eigen::Vector2d::Zero();  // m
  double blind_range = 0.0;  // m: the echo was too near to be measured, so that much before the point may be filled too
};

// One pose on the path.
struct PathPose {
  geometry::PlanePose X_RS;  // from where the robot is now
  double length = 0.0;       // m, of the path up to here; the first is 0, each greater than the one before
};

struct FreePath {
  double length = 0.0;    // m of the path that can be gone
  bool limited = false;   // false: the whole path can
  double distance = 0.0;  // m, from the outline as it is now to what limits the path
  double bearing = 0.0;   // rad, its direction in R
};

// m; 0 inside.
double distance_to_outline(const Outline& outline, const Eigen::Vector2d& p_R);

// The part of `path` on which the outline stays `clearance` (m, 0 or more) away from every point. What is nearer than
// that already forbids only paths that lead closer to it, anywhere on them, by more than the sonars' noise.
FreePath free_path(const Outline& outline, double clearance, const std::vector<SeenPoint>& points,
                   const std::vector<PathPose>& path);

// "ahead", "ahead on the left", ...: for people.
std::string side_of(double bearing);

}  // namespace markservo::base_navigator
