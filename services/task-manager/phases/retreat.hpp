#pragma once

// Out of the row, when the object cannot be taken as it was tried.

#include <string>

#include "services/task-manager/phases/active_phase.hpp"

namespace markservo::task_manager {

// The open hand leaves on the line on which it came; then the task has failed.
Transition back_off(PhaseContext& context, const std::string& failure);

// The hand puts the object down where it gripped it, lets go and leaves. Then the robot looks once more; after the
// second grip the task has failed.
Transition let_go(PhaseContext& context, const std::string& failure);

}  // namespace markservo::task_manager
