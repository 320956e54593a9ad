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
  // `moving`: the task is in a phase that needs visual-servo; `told`: a goal was sent; `now`: us of the task's time;
  // `timeout`: s, after which stale input, a stop of its own or no answer end the task.
  std::optional<Ending> observe(const ServoReport& servo, bool moving, bool told, std::int64_t now, double timeout);

 private:
  ConditionTimer stale_;
  ConditionTimer stopped_;
  ConditionTimer unheard_;
};

}  // namespace markservo::task_manager
