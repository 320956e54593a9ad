#pragma once

#include <string>

#include "services/stack-watch/supervisor/supervisor_words.hpp"

namespace markservo::stack_watch {

// Puts into `process` what its starts left in the folder of the supervisor's socket `path`: how often it crashed in a
// row, and how long its next start is waited for. Nothing where it left nothing.
void note_starts(const std::string& path, SupervisedProcess& process);

}  // namespace markservo::stack_watch
