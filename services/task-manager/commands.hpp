#pragma once

// Commands of people and programs: START, HOME, ABORT.

#include <optional>

#include "common/motion/command_inbox.hpp"
#include "services/task-manager/phases/active_phase.hpp"

namespace markservo::task_manager {

// What a command leads to in `phase`; nothing when it is a repeat (an ABORT is none while a task is under way), stale,
// or changes nothing. Whoever sent it reads the phase's reason or a notice. START makes `context.task` a new one,
// unless the hand holds the present one's object: that decides what HOME does.
std::optional<Transition> hear(const Command& command, Phase phase, motion::CommandInbox& inbox, PhaseContext& context);

}  // namespace markservo::task_manager
