#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {

// Which goal is followed: the newest one that no stop has ended.
class GoalMemory {
 public:
  enum class Heard { kNew, kAgain, kIgnored };

  // A goal is new once; what a stop has ended stays ended. While `latched` a goal is heard and ended at once.
  Heard hear(const Goal& goal, bool latched);

  // A stop: the goal, and all before it, will not be taken up again.
  void end();

  const std::optional<Goal>& goal() const { return goal_; }

 private:
  void drop(const Goal& goal);

  std::optional<Goal> goal_;                      // its utime is that of the newest repetition
  std::map<std::int64_t, std::int64_t> dropped_;  // a writer's session, its last goal that a stop has ended
};

}  // namespace markservo::base_navigator
