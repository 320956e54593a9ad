#include "services/task-manager/watches/servo_watch.hpp"

namespace markservo::task_manager {

std::optional<Ending> ServoWatch::observe(const ServoReport& servo, bool moving, bool told, std::int64_t now,
                                          double timeout) {
  const bool stale = stale_.observe(moving && servo.state == ServoState::kStale, now) > timeout;
  const bool stopped = stopped_.observe(moving && servo.state == ServoState::kStopped, now) > timeout;
  const bool unheard = unheard_.observe(moving && told && servo.goal_id == 0, now) > timeout;
  if (unheard) {
    return Ending{Phase::kFailed,
                  "visual-servo does not answer the goal" + (servo.reason.empty() ? "" : ": " + servo.reason)};
  }
  if (stopped) return Ending{Phase::kStopped, "visual-servo is stopped: " + servo.reason};
  if (stale) return Ending{Phase::kFailed, "the arm holds for want of fresh input: " + servo.reason};
  return std::nullopt;
}

}  // namespace markservo::task_manager
