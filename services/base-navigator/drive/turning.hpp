#pragma once

// Turning on the spot, and going where there is room for it.

#include <optional>

#include "common/geometry/plane_pose.hpp"
#include "services/base-navigator/drive/path_guard.hpp"
#include "services/base-navigator/drive/situation.hpp"

namespace markservo::base_navigator {

struct TurnParameters {
  double first = 0.6;      // rad off the course, from which on it turns on the spot before it drives
  double done = 0.02;      // rad, when that turn is done
  double room_max = 0.5;   // m, to go where it can turn; and as much again for each correction
  double room_step = 0.3;  // m of straight path that is looked at for room
};

// One step of a turn by `angle` (rad, counter-clockwise), with `clearance` (m) at most. It waits while the robot rolls.
GuardedTurn turn_on_spot(const PathGuard& guard, const Situation& situation, double clearance, double angle,
                         PassageState& passage);

// What it takes to go where a turn has room: straight away from what stands in its way, and no farther than allowed.
class TurningRoom {
 public:
  // Makes a step away from what blocks `turn`; nothing where that is not possible. `corrections`: made at the goal so
  // far.
  std::optional<Advice> step(const TurnParameters& parameters, const PathGuard& guard, const Situation& situation,
                             double clearance, const GuardedTurn& turn, int corrections);

  // To be called in every step, `turning` or not: counts how far the robot went since the last one, also what it rolls
  // on before it tries to turn again.
  void count(const Situation& situation, bool turning);

  double made() const { return made_; }  // m

 private:
  // Up to where the room that is being made has been counted.
  struct Counted {
    geometry::PlanePose X_OR;
    int epoch = 0;
  };

  double made_ = 0.0;
  std::optional<Counted> counted_;
};

}  // namespace markservo::base_navigator
