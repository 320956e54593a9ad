#pragma once

// What must hold before a command may lead to motion. Each says why not, for people; nothing ("") when it may.

#include <string>

#include "services/task-manager/phases/phase_context.hpp"

namespace markservo::task_manager {

// Why START may not begin a task.
std::string why_no_task(const Command& command, const PhaseContext& context);

// Why HOME may not move the arm.
std::string why_not_home(const PhaseContext& context);

// Whose first word a task waits for: the arm's, or a stop device's.
std::string who_is_silent(const Input& input);

}  // namespace markservo::task_manager
