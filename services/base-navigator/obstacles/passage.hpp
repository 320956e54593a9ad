#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/base-navigator/kinematics/motion.hpp"
#include "services/base-navigator/obstacles/free_path.hpp"

namespace markservo::base_navigator {

struct PassageParameters {
  double clearance = 0.15;       // m, for goals that state none
  double turn_clearance = 0.05;  // m, at most, on the spot: only corners move, slowly, and docked they must be able to
  double reaction = 0.15;        // s, from an echo to the brakes: half a scan, one command, the base's own delay
  double blocked_below = 0.012;  // m of free path: about the sonars' noise
  double free_above = 0.06;      // m of free path that end a blockade: well above that noise
  double free_for = 0.5;         // s, before it goes on
};

struct PassageState {
  bool blocked = false;
  std::int64_t free_since = 0;  // us; 0: not free
};

// What is left of a desired motion when its path is looked at.
struct Passage {
  Motion motion;
  bool blocked = false;
  std::string reason;  // what is in the way, where
};

// Slows `desired` down so that it stops `free.length` ahead at the latest; blocked below a small rest, until the path
// has been free for a while. `path_speed` (m/s, above 0) is the speed along the path; all speeds of `desired` scale
// with it.
Passage pass(const PassageParameters& parameters, double braking, const FreePath& free, double clearance,
             double path_speed, const Motion& desired, std::int64_t utime, PassageState& state);

}  // namespace markservo::base_navigator
