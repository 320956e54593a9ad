#pragma once

// TASK_COMMANDs between two steps. They are repeated until they are echoed: one that is no longer repeated has lost its
// sender, and must not begin to move the arm when vision comes back.

#include <cstdint>
#include <vector>

#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

class CommandQueue {
 public:
  using Time = std::int64_t;  // us of a clock that only goes forward

  // A repeat only renews what waits already. When kMost wait, the oldest makes room; an ABORT does so last.
  void add(const Command& command, Time now);
  // What is to be executed, in order of arrival; the queue is empty then. With `ageing`, without every START and HOME
  // that was not repeated for kPatience_us.
  std::vector<Command> take(Time now, bool ageing);
  std::size_t size() const { return waiting_.size(); }

  static constexpr Time kPatience_us = 1'500'000;  // several repeats, and a frame on a busy machine
  static constexpr std::size_t kMost = 16;

 private:
  struct Waiting {
    Command command;
    Time heard;
  };
  std::vector<Waiting> waiting_;
};

}  // namespace markservo::task_manager
