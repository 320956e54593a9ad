#pragma once

// Which goals were legal: those of the session that has the floor. Who speaks first has it while he repeats; legal is
// who writes alone, not a name.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/timeline.hpp"

namespace markservo::campaign {

inline constexpr double kStampsApart_s = 0.3;  // the trial hears the world's stamps a little late

// Who has the floor, as movers understand it: who speaks first while it repeats; another with something new once that
// has been silent for `age` (s). What was ignored or replaced is nothing new.
class Floor {
 public:
  explicit Floor(double age) : age_(age) {}

  // Whether the goal `id` of `session`, heard at `world` (s), has the floor.
  bool hear(std::int64_t session, std::int64_t id, double world) {
    const auto [known, first] = heard_.try_emplace(session, id);
    const bool something_new = first || id > known->second;
    known->second = std::max(known->second, id);
    if (session != holder_) {
      if (world - held_ <= age_ || !something_new) return false;
      holder_ = session;
    }
    held_ = world;
    return true;
  }
  std::int64_t holder() const { return holder_; }

 private:
  double age_;
  std::int64_t holder_ = 0;
  double held_ = -1e9;                          // s, world, when the holder last spoke
  std::map<std::int64_t, std::int64_t> heard_;  // by session: the greatest id
};

// Calls `hear(goal)` for each goal that is of its time, no older or newer than `age` (s) by the world's own stamps, in
// the order in which they were heard.
template <class M, class Hear>
void each_timely_goal(const Timeline& timeline, const Stream<M>& goals, double age, Hear hear) {
  std::int64_t now = 0;
  auto truth = timeline.base_truth.begin();
  for (const auto& goal : goals) {
    for (; truth != timeline.base_truth.end() && truth->t <= goal.t; ++truth) now = truth->message.utime;
    if (now > 0 && std::abs(seconds_between(goal.message.utime, now)) > age + kStampsApart_s) continue;
    hear(goal);
  }
}

// The goals to move (of another kind than `hold`) that a mover may follow, in the order in which they were heard: of
// the session that has the floor. What the trial sent under a session of the stack's is never legal.
template <class M>
std::vector<const Heard<M>*> legal_goals(const Timeline& timeline, const Stream<M>& goals, int hold, double age) {
  std::vector<const Heard<M>*> legal;
  Floor floor(age);
  each_timely_goal(timeline, goals, age, [&](const Heard<M>& goal) {
    if (goal.foreign && timeline.is("task-manager", goal.message.session)) return;
    if (!floor.hear(goal.message.session, goal.message.goal_id, goal.world)) return;
    if (goal.message.kind != hold) legal.push_back(&goal);
  });
  return legal;
}

// Which session had the floor from when until when; s, world.
struct FloorHolder {
  double from = 0.0;
  double until = 0.0;  // its last word, and as long as that counts
  std::int64_t session = 0;
};

template <class M>
std::vector<FloorHolder> floor_holders(const Timeline& timeline, const Stream<M>& goals, double age) {
  std::vector<FloorHolder> holders;
  Floor floor(age);
  each_timely_goal(timeline, goals, age, [&](const Heard<M>& goal) {
    const std::int64_t session = goal.message.session;
    if (!floor.hear(session, goal.message.goal_id, goal.world)) return;
    if (holders.empty() || holders.back().session != session) holders.push_back({goal.world, goal.world, session});
    holders.back().until = goal.world + age;
  });
  return holders;
}

// Whether `session` had the floor at some time within [from, to].
inline bool had_the_floor(const std::vector<FloorHolder>& holders, std::int64_t session, double from, double to) {
  return std::any_of(holders.begin(), holders.end(), [&](const FloorHolder& holder) {
    return holder.session == session && holder.from <= to && holder.until >= from;
  });
}

}  // namespace markservo::campaign
