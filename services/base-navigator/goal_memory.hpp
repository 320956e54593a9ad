#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {

// Which goal is followed: the newest one that no stop has ended.
//
// Each writer's goals are told apart by growing ids, and a goal is new once: what another writer's goal, a later one or
// a stop has ended stays ended, though it is repeated. Else two writers would each make the other's goal new, and one
// relative to the robot would move on with it for ever.
class GoalMemory {
 public:
  enum class Heard { kNew, kAgain, kIgnored };

  // `now`: us, the newest odometry's utime; 0 before the first. `goal_age`: s, beyond which from now the present goal
  // has aged out; until then another writer's goal is not taken if it is older. While `latched` a goal is heard and
  // ended at once.
  Heard hear(const Goal& goal, std::int64_t now, double goal_age, bool latched);

  // A stop: the goal, and all before it of its writer, will not be taken up again.
  void end() { goal_.reset(); }

  // The clock went back to `now` (us): likewise, but for a goal that is of the new time, `goal_age` s from it at most.
  void end_unless_near(std::int64_t now, double goal_age);

  const std::optional<Goal>& goal() const { return goal_; }

 private:
  struct Writer {
    std::int64_t session;
    std::int64_t last_id;  // of the goals heard from it
  };

  bool heard_before(const Goal& goal) const;
  void remember(const Goal& goal);

  std::optional<Goal> goal_;    // its utime is that of the newest repetition
  std::deque<Writer> writers_;  // the one that last had a new goal comes last
};

}  // namespace markservo::base_navigator
