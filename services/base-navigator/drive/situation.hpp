#pragma once

// What every stage of a drive is given, and what it answers.

#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "services/base-navigator/kinematics/motion.hpp"
#include "services/base-navigator/navigator_types.hpp"
#include "services/base-navigator/obstacles/free_path.hpp"

namespace markservo::base_navigator {

// Where things are now.
struct Situation {
  std::int64_t utime = 0;
  geometry::PlanePose X_OR;  // by the wheels alone: without the jumps of X_WR; O is another frame when epoch is another
  int epoch = 0;
  geometry::PlanePose X_WR;
  double position_sigma = 0.0;  // m, along the worst axis
  double heading_sigma = 0.0;   // rad
  Command measured;
  std::vector<SeenPoint> points;
};

// Where it shall drive, and how.
struct Assignment {
  geometry::PlanePose X_WG;
  double clearance = 0.0;  // m
  double speed = 0.0;      // m/s, at most
};

struct Advice {
  Motion motion;
  DriveState state = DriveState::kDriving;
  std::string reason;
};

}  // namespace markservo::base_navigator
