#include "services/stack-watch/supervisor/supervisor_memory.hpp"

#include <utility>

namespace markservo::stack_watch {

SupervisorMemory::News SupervisorMemory::observe(SupervisorAnswer answer, std::int64_t wall_us) {
  if (!answer.cannot_ask.empty()) {
    const bool news = answer.cannot_ask != newest_.cannot_ask;
    newest_.cannot_ask = std::move(answer.cannot_ask);
    return news ? News::kCannotBeAsked : News::kNone;
  }
  const bool changed = answer.alive != newest_.alive;
  if (changed) changed_us_ = wall_us;
  ever_alive_ = answer.alive || ever_alive_;
  if (!answer.alive) {
    answer.processes = std::move(newest_.processes);
    answer.running = std::move(newest_.running);
  }
  newest_ = std::move(answer);
  if (!changed) return News::kNone;
  return newest_.alive ? News::kAnswers : News::kDied;
}

}  // namespace markservo::stack_watch
