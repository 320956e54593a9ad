#pragma once

// From a known pose to a goal pose: turn towards it, drive, turn to its heading, stand, look again, correct.

#include "services/base-navigator/drive/arrival.hpp"
#include "services/base-navigator/drive/leg_drive.hpp"
#include "services/base-navigator/drive/leg_plan.hpp"
#include "services/base-navigator/drive/path_guard.hpp"
#include "services/base-navigator/drive/situation.hpp"
#include "services/base-navigator/drive/turning.hpp"
#include "services/base-navigator/obstacles/passage.hpp"

namespace markservo::base_navigator {

struct ManoeuvreParameters {
  ArrivalParameters arrival;
  LegParameters legs;
  LegDriveParameters drive;
  TurnParameters turn;
  double obstacle_at_goal = 0.08;  // m; so near the goal an obstacle may be the goal's own shelf, met askew
};

enum class Phase { kPlan, kTurnToCourse, kDrive, kTurnToHeading, kSettle, kArrived, kGivenUp };

struct ManoeuvreState {
  Phase phase = Phase::kPlan;
  Leg leg;
  bool staged = false;   // the staging pose before the goal has been used
  PassageState passage;  // of the turn or leg that is under way
  TurningRoom room;
  Arrival arrival;
};

class Manoeuvre {
 public:
  Manoeuvre(const PathGuard& guard, const ManoeuvreParameters& parameters) : guard_(guard), parameters_(parameters) {}

  Advice step(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const;

  // To be called at a pause for another reason: what was under way is planned anew.
  static void interrupt(ManoeuvreState& state);

 private:
  void plan(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const;
  Advice turn(const Situation& situation, const Assignment& goal, double angle, ManoeuvreState& state) const;
  Advice drive(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const;
  Advice settle(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const;
  static void end_leg(ManoeuvreState& state);
  bool ends_at_obstacle(const Situation& situation, const Assignment& goal, const ManoeuvreState& state) const;

  PathGuard guard_;
  ManoeuvreParameters parameters_;
};

}  // namespace markservo::base_navigator
