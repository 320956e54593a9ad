#include "services/task-manager/watches/servo_watch.hpp"

namespace markservo::task_manager {

std::optional<Ending> ServoWatch::observe(const ServoReport& servo, bool moving, std::int64_t goal_id, std::int64_t now,
                                          double timeout) {
  const bool stale = stale_.observe(moving && servo.state == ServoState::kStale, now) > timeout;
  const bool stopped = stopped_.observe(moving && servo.state == ServoState::kStopped, now) > timeout;
  const bool unheard = unheard_.observe(moving && goal_id != 0 && servo.goal_id != goal_id, now) > timeout;
  if (unheard) {
    return Ending{Phase::kFailed,
                  "visual-servo does not answer the goal" + (servo.reason.empty() ? "" : ": " + servo.reason)};
  }
  if (stopped) return Ending{Phase::kStopped, "visual-servo is stopped: " + servo.reason};
  if (stale) return Ending{Phase::kFailed, "the arm holds for want of fresh input: " + servo.reason};
  return std::nullopt;
}

}  // namespace markservo::task_manager
