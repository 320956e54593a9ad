#pragma once

// Learning the heading. Tags alone do not tell a robot that stands which way it looks: it creeps straight ahead, or
// back where something is ahead, until they do.

#include <optional>

#include "common/geometry/plane_pose.hpp"
#include "services/base-navigator/drive/path_guard.hpp"
#include "services/base-navigator/drive/situation.hpp"

namespace markservo::base_navigator {

struct ExploreParameters {
  bool enabled = true;
  double speed = 0.1;            // m/s
  double distance = 0.4;         // m at most: four tags
  double heading_known = 0.15;   // rad, the sigma at which it ends
  double position_sigma = 0.20;  // m; without a heading the position is known less well while it moves
  double room_ahead = 0.1;       // m of free path; with less it goes back where there is more
};

class Exploration {
 public:
  // What to do to learn the heading; nothing while it is known: to `heading_sigma` (rad) when the robot stands, better
  // once it has begun to creep.
  std::optional<Advice> step(const ExploreParameters& parameters, double heading_sigma, const PathGuard& guard,
                             const Situation& situation, double clearance);

  // To be called at a pause for another reason: the next step begins anew.
  void interrupt() { active_ = false; }
  // To be called for another goal: the heading may be looked for once more.
  void forget_failure() { failed_ = false; }

  // It has gone as far as it may, in vain.
  bool failed() const { return failed_; }

 private:
  void begin(const ExploreParameters& parameters, const PathGuard& guard, const Situation& situation, double clearance);

  bool active_ = false;
  bool failed_ = false;
  int epoch_ = 0;  // of O, in which it has begun
  geometry::PlanePose X_OR_start_;
  Direction direction_ = Direction::kForward;
  PassageState passage_;
};

}  // namespace markservo::base_navigator
