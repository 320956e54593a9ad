#pragma once

// What the base shall do, and how a command gets there from what it does now.

#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {

struct MotionParameters {
  double speed = 0.5;              // m/s, towards goals that ask for no less; the tags' reads are few at more
  double turn_rate = 1.0;          // rad/s
  double acceleration = 0.4;       // m/s^2, gaining and losing speed; half of what the base can, so it has reserve
  double turn_acceleration = 2.0;  // rad/s^2
  double braking = 0.8;            // m/s^2, for what stands in the way: robot.yaml's acceleration_max
  double turn_braking = 6.28;      // rad/s^2, likewise
  double command_lead = 0.3;       // s of acceleration by which a command may be ahead of the measured speed
  double goal_reaction = 0.25;     // s, for stopping at a pose: above twice the base's delay, else it would swing
  double creep = 0.03;             // m/s, on the last centimetre
  double turn_creep = 0.06;        // rad/s, likewise
  double rolling = 0.03;           // m/s; a base so fast has not yet stopped for a turn, or to go the other way
};

// What one step asks for.
struct Motion {
  double speed = 0.0;      // m/s, backward below 0
  double curvature = 0.0;  // rad per m of path
  double turn_rate = 0.0;  // rad/s, beside what the curvature makes
  bool brake = false;      // with all the base can
};

inline Motion stand() {
  return Motion();
}
inline Motion brake() {
  Motion motion;
  motion.brake = true;
  return motion;
}

// The command `seconds` after `previous`, on the way to `motion`. It begins at the measured speed: a base that does not
// follow is not told ever more.
Command next_command(const MotionParameters& parameters, const Motion& motion, const Command& previous,
                     const Command& measured, double seconds);

}  // namespace markservo::base_navigator
