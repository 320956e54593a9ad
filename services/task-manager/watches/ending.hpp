#pragma once

#include <string>

#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

// How a watch wants a task to end.
struct Ending {
  Phase phase = Phase::kStopped;  // or kFailed, kRefused
  std::string reason;
};

// Whether there is something for a STOP to end: a task under way, or an object held up.
inline bool stop_ends(Phase phase) {
  return under_way(phase) || phase == Phase::kHoldLifted;
}

}  // namespace markservo::task_manager
