#pragma once

// From a known pose to a goal pose: turn towards it, drive, turn to its heading, stand, look again, correct.

#include <cstdint>
#include <optional>
#include <string>

#include "services/base-navigator/drive/leg_plan.hpp"
#include "services/base-navigator/drive/path_guard.hpp"
#include "services/base-navigator/drive/situation.hpp"
#include "services/base-navigator/kinematics/course.hpp"
#include "services/base-navigator/kinematics/motion.hpp"
#include "services/base-navigator/obstacles/passage.hpp"

namespace markservo::base_navigator {

struct ArrivalParameters {
  double position = 0.02;         // m, arrived within
  double heading = 0.052;         // rad (3 degrees), likewise
  double coarse_position = 0.03;  // m, will do once the corrections are used up or there is no room for them
  double coarse_heading = 0.087;  // rad (5 degrees), likewise
  double leave_position = 0.05;   // m, from which on an arrived robot has been moved away and drives again
  double leave_heading = 0.14;    // rad, likewise
  int corrections = 4;            // after which it takes the coarse tolerance or gives up
  double settle_time = 0.8;       // s standing before the pose is judged: at rest the reads sharpen it
  double settle_time_max =
      3.0;  // s, while the position's sigma is above half the tolerance; reads do not tell a heading
  double standing_speed = 0.01;      // m/s; the encoders' ticks make 0.002
  double standing_turn_rate = 0.05;  // rad/s
};

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
  bool staged = false;  // the staging pose before the goal has been used
  int corrections = 0;
  std::int64_t standing_since = 0;    // us; 0: not standing
  double room_made = 0.0;             // m gone to where it can turn
  std::optional<RoomMark> room_mark;  // while it is being made: up to where that is counted
  PassageState passage;
  std::string given_up;  // why
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
  void correct(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const;
  bool ends_at_obstacle(const Situation& situation, const Assignment& goal, const ManoeuvreState& state) const;
  bool standing(const Situation& situation) const;

  PathGuard guard_;
  ManoeuvreParameters parameters_;
};

}  // namespace markservo::base_navigator
