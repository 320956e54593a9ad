#include "services/task-manager/command_queue.hpp"

#include <algorithm>

namespace markservo::task_manager {

void CommandQueue::add(const Command& command, Time now) {
  const auto known = std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& other) {
    return other.command.session == command.session && other.command.id == command.id;
  });
  if (known != waiting_.end()) {
    known->heard = now;
    return;
  }
  if (waiting_.size() >= kMost) {
    const auto moves = std::find_if(waiting_.begin(), waiting_.end(),
                                    [](const Waiting& other) { return other.command.kind != CommandKind::kAbort; });
    waiting_.erase(moves == waiting_.end() ? waiting_.begin() : moves);
  }
  waiting_.push_back({command, now});
}

std::vector<Command> CommandQueue::take(Time now, bool ageing) {
  std::vector<Command> commands;
  for (const Waiting& waiting : waiting_) {
    const bool old = ageing && waiting.command.kind != CommandKind::kAbort && now - waiting.heard > kPatience_us;
    if (!old) commands.push_back(waiting.command);
  }
  waiting_.clear();
  return commands;
}

}  // namespace markservo::task_manager
