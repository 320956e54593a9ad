#pragma once

// What arm and base were told last, and when it is to be sent: at once when it is new, then five times a second; as a
// new one when nobody heard it.

#include <cstdint>
#include <optional>
#include <utility>

#include "common/bus/repeat_timer.hpp"
#include "services/task-manager/goal_numbers.hpp"
#include "services/task-manager/procedure_types.hpp"
#include "services/task-manager/watches/condition_timer.hpp"

namespace markservo::task_manager {

// G: Goal or DriveGoal.
template <class G>
class RepeatedGoal {
 public:
  // The newest; its id is 0 before the first.
  const G& newest() const { return newest_; }
  bool none_yet() const { return newest_.id == 0; }

  // Its mover reports at `utime` (us) that it follows our goal `id`; 0: none of ours.
  void observe(std::int64_t id, std::int64_t utime) { numbers_.observe(id, utime); }

  // A new goal, under the next id.
  void set(G goal) {
    goal.id = numbers_.next(newest_.id);
    newest_ = std::move(goal);
    is_new_ = true;
  }

  // Sets the goal anew when it has been ignored for more than a second. `is_ignored`: at `utime` (us, of messages).
  void insist(bool is_ignored, std::int64_t utime) {
    constexpr double kUnanswered_s = 1.0;
    if (ignored_.observe(is_ignored && !none_yet(), utime) <= kUnanswered_s) return;
    ignored_ = ConditionTimer();
    set(newest_);
  }

  // The goal, if it is to be sent at `utime` (us, of messages: receivers judge its age by that).
  std::optional<G> due(std::int64_t utime) {
    if (none_yet() || !(is_new_ || repeat_.due(utime))) return std::nullopt;
    repeat_.restart(utime);
    is_new_ = false;
    return newest_;
  }

 private:
  G newest_;
  GoalNumbers numbers_;
  bool is_new_ = false;
  bus::RepeatTimer repeat_{bus::kStateRepeat_us};
  ConditionTimer ignored_;
};

using ArmGoals = RepeatedGoal<Goal>;

class BaseGoals : public RepeatedGoal<DriveGoal> {
 public:
  // Tells the base to stand, unless it was told so last.
  void hold() {
    if (newest().drive || none_yet()) set(DriveGoal());
  }
};

}  // namespace markservo::task_manager
