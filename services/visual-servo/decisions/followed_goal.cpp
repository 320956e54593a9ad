#include "services/visual-servo/decisions/followed_goal.hpp"

#include "common/motion/freshness.hpp"

namespace markservo::visual_servo {

motion::GoalHeard FollowedGoal::observe(const Goal& goal, std::int64_t now, double age, bool latched) {
  const auto heard = inbox_.hear({goal.session, goal.id, goal.utime}, now, age, latched);
  if (!inbox_.goal()) goal_.reset();
  if (heard == motion::GoalHeard::kAgain) goal_->utime = inbox_.goal()->utime;
  if (heard == motion::GoalHeard::kNew) {
    goal_ = goal;
    refusal_.clear();
    dropped_.clear();
  }
  return heard;
}

void FollowedGoal::end() {
  inbox_.end();
  goal_.reset();
}

void FollowedGoal::drop(const std::string& why) {
  if (goal_) dropped_ = why + ": the goal was dropped";
  end();
}

void FollowedGoal::end_unless_fresh(std::int64_t now, double age) {
  if (!inbox_.end_unless_fresh(now, age)) return;
  dropped_ = "the goal heard before the first JOINT_STATE is of another time: it was dropped";
  goal_.reset();
}

std::string FollowedGoal::why_stale(std::int64_t now, double age) const {
  if (!goal_) return "";
  return why_not_fresh(motion::Freshness{"SERVO_GOAL", "JOINT_STATE", age, age}, goal_->utime, now);
}

}  // namespace markservo::visual_servo
