#pragma once

// From a known pose to a goal pose: turn towards it, drive, turn to its heading, stand, look again, correct.

#include <optional>

#include "services/base-navigator/drive/arrival.hpp"
#include "services/base-navigator/drive/leg_plan.hpp"
#include "services/base-navigator/drive/path_guard.hpp"
#include "services/base-navigator/drive/situation.hpp"
#include "services/base-navigator/kinematics/course.hpp"
#include "services/base-navigator/kinematics/motion.hpp"
#include "services/base-navigator/obstacles/passage.hpp"

namespace markservo::base_navigator {

struct ManoeuvreParameters {
  ArrivalParameters arrival;
  CourseParameters course;
  LegParameters legs;
  MotionParameters motion;
  PassageParameters passage;
  double goal_reaction = 0.25;     // s, for stopping at a pose: above twice the base's delay, else it would swing
  double creep = 0.03;             // m/s, on the last centimetre
  double turn_creep = 0.06;        // rad/s
  double turn_first = 0.6;         // rad off the course, from which on it turns on the spot
  double turned = 0.02;            // rad, when that turn is done
  double off_course = 1.2;         // rad off the course while driving: the pose has jumped, plan anew
  double obstacle_at_goal = 0.08;  // m; so near the goal an obstacle may be the goal's own shelf, met askew
  double room_step_max = 0.5;      // m, to go where it can turn; and as much again for each correction
};

enum class Phase { kPlan, kTurnToCourse, kDrive, kTurnToHeading, kSettle, kArrived, kGivenUp };

struct RoomMark {
  geometry::PlanePose X_OR;
  int epoch = 0;
};

struct ManoeuvreState {
  Phase phase = Phase::kPlan;
  Leg leg;
  bool staged = false;                // the staging pose before the goal has been used
  double room_made = 0.0;             // m gone to where it can turn
  std::optional<RoomMark> room_mark;  // while it is being made: up to where that is counted
  PassageState passage;
  Arrival arrival;
};

class Manoeuvre {
 public:
  Manoeuvre(const PathGuard& guard, const ManoeuvreParameters& parameters) : guard_(guard), parameters_(parameters) {}

  Advice step(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const;

  // After a pause for another reason: what was under way is planned anew.
  static void interrupt(ManoeuvreState& state);

 private:
  void plan(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const;
  static void count_room(const Situation& situation, ManoeuvreState& state);
  Advice turn(const Situation& situation, const Assignment& goal, double angle, ManoeuvreState& state) const;
  Advice make_room(const Situation& situation, const Assignment& goal, const GuardedTurn& blocked,
                   ManoeuvreState& state) const;
  Advice drive(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const;
  Advice settle(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const;
  void end_leg(ManoeuvreState& state) const;
  bool ends_at_obstacle(const Situation& situation, const Assignment& goal, const ManoeuvreState& state) const;

  PathGuard guard_;
  ManoeuvreParameters parameters_;
};

}  // namespace markservo::base_navigator
