#pragma once

// When the log has something new to say of the task.

#include <cstdint>
#include <optional>

#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

class TaskLog {
 public:
  // s since the task began (0 before the first one), where phase, reason or command are not as they were told last.
  std::optional<double> news(const Output& output, std::int64_t utime);

 private:
  std::optional<Output> told_;
  std::int64_t task_began_ = 0;  // us
};

}  // namespace markservo::task_manager
