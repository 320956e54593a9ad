#include "services/base-navigator/goal_memory.hpp"

#include <algorithm>
#include <iterator>

namespace markservo::base_navigator {

GoalMemory::Heard GoalMemory::hear(const Goal& goal, bool latched) {
  const auto dropped = dropped_.find(goal.session);
  if (dropped != dropped_.end() && goal.id <= dropped->second) return Heard::kIgnored;
  if (latched) {
    drop(goal);
    return Heard::kIgnored;
  }
  if (goal_) {
    const bool same_session = goal.session == goal_->session;
    if (same_session && goal.id < goal_->id) return Heard::kIgnored;
    if (!same_session && goal.utime < goal_->utime) return Heard::kIgnored;
    if (same_session && goal.id == goal_->id) {
      goal_->utime = std::max(goal_->utime, goal.utime);
      return Heard::kAgain;
    }
  }
  goal_ = goal;
  return Heard::kNew;
}

void GoalMemory::end() {
  if (!goal_) return;
  drop(*goal_);
  goal_.reset();
}

void GoalMemory::drop(const Goal& goal) {
  constexpr std::size_t kSenders = 64;  // as many as a hostile one may make us remember
  dropped_[goal.session] = goal.id;
  if (dropped_.size() <= kSenders) return;
  const auto first = dropped_.begin();
  dropped_.erase(first->first == goal.session ? std::next(first) : first);
}

}  // namespace markservo::base_navigator
