#pragma once

// How a task ends, and how it begins: transitions that several phases come to.

#include <optional>
#include <string>

#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/watches/ending.hpp"
#include "services/task-manager/watches/move_watch.hpp"

namespace markservo::task_manager {

Transition look_for_target(const PhaseContext& context);

Transition refused(const std::string& reason);
Transition failed(const std::string& reason);
Transition stopped(const std::string& reason);
Transition transition_to(const Ending& ending);

// What follows from moves that are not done: nothing while they are under way, the task's end when one has failed.
std::optional<Transition> not_done(const MoveReport& report);

// The target cannot be taken: refused, or failed when the base has driven or the arm has tried once.
Transition not_taken(const PhaseContext& context, const std::string& reason);

}  // namespace markservo::task_manager
