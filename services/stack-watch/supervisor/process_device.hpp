#pragma once

#include <string>
#include <vector>

#include "services/stack-watch/silence.hpp"
#include "services/stack-watch/supervisor/supervisor_words.hpp"

namespace markservo::stack_watch {

// Those of `processes`, as the supervisor told them last, that run on though it is dead, as "NAME (pid N), ...";
// "none".
std::string orphans(const std::vector<SupervisedProcess>& processes);

// Kills it if the supervisor at `path` says that it runs still; whether it did. Logs, also why not.
bool kill_if_supervised(const SilentService& silent, const std::string& path);

}  // namespace markservo::stack_watch
