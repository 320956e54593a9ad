#include "services/task-manager/command_queue.hpp"

#include <algorithm>
#include <utility>

namespace markservo::task_manager {

void CommandQueue::add(const Command& command) {
  const auto known = std::find_if(waiting_.begin(), waiting_.end(), [&](const Command& other) {
    return other.session == command.session && other.id == command.id && other.kind == command.kind;
  });
  if (known != waiting_.end()) {
    *known = command;
    return;
  }
  if (waiting_.size() >= kMost) {
    const auto moves = std::find_if(waiting_.begin(), waiting_.end(),
                                    [](const Command& other) { return other.kind != CommandKind::kAbort; });
    waiting_.erase(moves == waiting_.end() ? waiting_.begin() : moves);
  }
  waiting_.push_back(command);
}

std::vector<Command> CommandQueue::take() {
  return std::exchange(waiting_, {});
}

}  // namespace markservo::task_manager
