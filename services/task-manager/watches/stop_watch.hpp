#pragma once

// What the stop devices together mean for the task.

#include <optional>

#include "services/task-manager/procedure_types.hpp"
#include "services/task-manager/watches/ending.hpp"

namespace markservo::task_manager {

class StopWatch {
 public:
  // `waits_for_first_word`: nothing has moved for the task yet, and it goes on only when each device has spoken. Then
  // silence ends nothing, and a first word of a stop that is reset by now does not either.
  std::optional<Ending> observe(const StopReport& stop, Phase phase, bool waits_for_first_word);

  // A stop was reset since the step before: what was sent until then is not obeyed any more.
  bool was_reset() const { return was_reset_; }

 private:
  bool was_known_ = false;
  bool was_latched_ = false;
  bool was_reset_ = false;
};

}  // namespace markservo::task_manager
