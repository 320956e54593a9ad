#pragma once

// How a goal is reached: where the next leg ends, with which heading, and whether it is driven forward.

#include "common/geometry/plane_pose.hpp"
#include "services/base-navigator/kinematics/course.hpp"

namespace markservo::base_navigator {

struct LegParameters {
  double heading_within = 0.8;    // rad between path and goal's heading, up to which the path curves into it
  double reverse_within = 1.0;    // m; a goal so near behind the robot is reversed to: its sonars look there too
  double docking_below = 0.15;    // m of clearance; such a goal is entered straight, as there is no room to turn at it
  double staging_distance = 0.5;  // m before it, from where it is entered
  double at_goal = 0.012;         // m; so near, nothing but the heading is left to be corrected
  double beside_within = 0.012;   // m beside the goal's axis that need no staging: a straight move does
  double near = 0.15;             // m; so near a goal is a correction, not a journey
  double back_off = 0.3;          // m, to take out what is beside the axis
  double back_off_least = 0.1;    // m of room, below which that gains nothing
};

struct Leg {
  geometry::PlanePose X_WV;  // where it ends; x is the direction in which the robot looks there
  Direction direction = Direction::kForward;
  bool to_goal = true;  // false: another leg follows
};

struct LegPlan {
  bool there = false;  // only the heading may be left
  Leg leg;
};

// `room_behind` and `room_ahead`: m that can be gone straight, looked at as far as a correction needs.
// `staged`: the staging pose before the goal has been used already.
LegPlan plan_leg(const LegParameters& parameters, const geometry::PlanePose& X_WR, const geometry::PlanePose& X_WG,
                 bool docking, bool staged, double room_behind, double room_ahead);

}  // namespace markservo::base_navigator
