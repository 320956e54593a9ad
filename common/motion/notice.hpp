#pragma once

// What a reader tells of others beside its own state.

#include <string>

#include "common/motion/goal_inbox.hpp"
#include "common/motion/mover_watch.hpp"

namespace markservo::motion {

// Why nothing may move; else who sends a second goal; else who writes in the mover's place. `goal_age`: s, as the goals
// are heard with. Empty when nothing is to be told.
std::string notice(const MoverWatch& mover, const GoalInbox& goals, double goal_age);

}  // namespace markservo::motion
