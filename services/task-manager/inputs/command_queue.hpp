#pragma once

// TASK_COMMANDs between two steps. What is executed of them, and whether they are still fresh then, is the inbox's
// matter.

#include <cstddef>
#include <vector>

#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

class CommandQueue {
 public:
  // A repeat replaces what waits already, of its kind: it is stamped anew. When kMost wait, the oldest makes room; an
  // ABORT does so last.
  void add(const Command& command);
  // What came since the last call, in order of arrival.
  std::vector<Command> take();
  std::size_t size() const { return waiting_.size(); }

  static constexpr std::size_t kMost = 16;

 private:
  std::vector<Command> waiting_;
};

}  // namespace markservo::task_manager
