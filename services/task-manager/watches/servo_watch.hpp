#pragma once

// Whether visual-servo does what it is told, whatever that is.

#include <cstdint>
#include <optional>

#include "services/task-manager/procedure_types.hpp"
#include "services/task-manager/watches/condition_timer.hpp"
#include "services/task-manager/watches/ending.hpp"

namespace markservo::task_manager {

class ServoWatch {
 public:
  // `moving`: the task is in a phase that needs visual-servo; `goal_id`: of what it was told last, 0 before that;
  // `now`: us of the task's time; `timeout`: s, after which stale input, a stop of its own or no answer end the task.
  std::optional<Ending> observe(const ServoReport& servo, bool moving, std::int64_t goal_id, std::int64_t now,
                                double timeout);

 private:
  ConditionTimer stale_;
  ConditionTimer stopped_;
  ConditionTimer unheard_;
};

}  // namespace markservo::task_manager
