#include "services/base-navigator/goal_memory.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::base_navigator {
namespace {

constexpr std::size_t kWriters = 64;  // as many as a hostile one may make us remember

// Whether a repetition at `utime` tells more of the goal's age than the one at `known`. The later one does, unless it
// is ahead of the clock by more than the other is behind: a clock that went back leaves such times.
bool fresher(std::int64_t utime, std::int64_t known, std::int64_t now) {
  if (now == 0) return utime > known;
  return std::abs(seconds_between(utime, now)) < std::abs(seconds_between(known, now));
}

}  // namespace

GoalMemory::Heard GoalMemory::hear(const Goal& goal, std::int64_t now, double goal_age, bool latched) {
  if (goal_ && goal.session == goal_->session && goal.id == goal_->id) {
    if (fresher(goal.utime, goal_->utime, now)) goal_->utime = goal.utime;
    return Heard::kAgain;
  }
  if (heard_before(goal)) return Heard::kIgnored;
  if (goal_ && goal.session != goal_->session && goal.utime < goal_->utime) {
    const bool aged_out = now != 0 && std::abs(seconds_between(goal_->utime, now)) > goal_age;
    if (!aged_out) return Heard::kIgnored;
  }
  remember(goal);
  if (latched) return Heard::kIgnored;
  goal_ = goal;
  return Heard::kNew;
}

void GoalMemory::end_unless_near(std::int64_t now, double goal_age) {
  if (goal_ && std::abs(seconds_between(goal_->utime, now)) > goal_age) end();
}

bool GoalMemory::heard_before(const Goal& goal) const {
  return std::any_of(writers_.begin(), writers_.end(), [&goal](const Writer& writer) {
    return writer.session == goal.session && goal.id <= writer.last_id;
  });
}

void GoalMemory::remember(const Goal& goal) {
  const auto known = std::find_if(writers_.begin(), writers_.end(),
                                  [&goal](const Writer& writer) { return writer.session == goal.session; });
  if (known != writers_.end()) writers_.erase(known);
  writers_.push_back({goal.session, goal.id});
  if (writers_.size() > kWriters) writers_.pop_front();
}

}  // namespace markservo::base_navigator
