#pragma once

// The goal that is followed, and what became of the one before: whether its sender still repeats it (motion::GoalInbox
// decides whose goal counts), why it cannot be followed, why it was dropped.

#include <cstdint>
#include <optional>
#include <string>

#include "common/motion/goal_inbox.hpp"
#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

class FollowedGoal {
 public:
  // A goal, new or repeated, and what became of it. `now`: us, of the joints, 0 before any; `age`: s, within which
  // goals are fresh; `latched`: the stop is, so that no goal is followed.
  motion::GoalHeard observe(const Goal& goal, std::int64_t now, double age, bool latched);
  // The new goal cannot be followed at all; `why` for people, empty when it can.
  void refuse(const std::string& why) { refusal_ = why; }

  // Ends the goal: it will not be taken up again, though it is repeated.
  void end();
  // Ends it likewise, since something began anew; `why` for people.
  void drop(const std::string& why);
  // To be called at the first time that is known, `now` (us): ends a goal that came before, unless it is fresh then, so
  // that none waits for its hour.
  void end_unless_fresh(std::int64_t now, double age);

  const std::optional<Goal>& goal() const { return goal_; }
  // Nothing is to move: there is none, or one that says so.
  bool holds() const { return !goal_ || goal_->kind == GoalKind::kHold; }
  const std::string& refusal() const { return refusal_; }  // of goal()
  // Why none is followed.
  std::string why_none() const { return dropped_.empty() ? "no goal" : dropped_; }
  // Why its sender counts as lost at `now` (us): not repeated for more than `age` (s). Empty when it does not.
  std::string why_stale(std::int64_t now, double age) const;

  const motion::GoalInbox& inbox() const { return inbox_; }

 private:
  motion::GoalInbox inbox_{"SERVO_GOAL"};
  std::optional<Goal> goal_;  // what inbox_.goal() asks for
  std::string refusal_;
  std::string dropped_;  // why the last goal was dropped, until the next one
};

}  // namespace markservo::visual_servo
