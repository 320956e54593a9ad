#pragma once

// Which goals were legal: those of the session that has the floor. Who speaks first has it while he repeats; legal is
// who writes alone, not a name.

#include <cmath>
#include <cstdint>
#include <vector>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/timeline.hpp"

namespace markservo::campaign {

inline constexpr double kStampsApart_s = 0.3;  // the trial hears the world's stamps a little late

// The goals to move (of another kind than `hold`) that a mover may follow, in the order in which they were heard: of
// the session that has the floor, and no older or newer than `age` (s) by the world's own stamps. What the trial sent
// under a session of the stack's is never legal.
template <class M>
std::vector<const Heard<M>*> legal_goals(const Timeline& timeline, const Stream<M>& goals, int hold, double age) {
  std::vector<const Heard<M>*> legal;
  std::int64_t holder = 0;
  double held = -1e9;  // s, world, when the holder last spoke
  std::int64_t now = 0;
  auto truth = timeline.base_truth.begin();
  for (const auto& goal : goals) {
    for (; truth != timeline.base_truth.end() && truth->t <= goal.t; ++truth) now = truth->message.utime;
    if (goal.message.session != holder && goal.world - held > age) holder = goal.message.session;
    if (goal.message.session != holder) continue;
    if (goal.foreign && timeline.is("task-manager", holder)) continue;
    if (now > 0 && std::abs(seconds_between(goal.message.utime, now)) > age + kStampsApart_s) continue;
    held = goal.world;
    if (goal.message.kind != hold) legal.push_back(&goal);
  }
  return legal;
}

// Which session had the floor from when on.
struct FloorHolder {
  double from = 0.0;  // s, world
  std::int64_t session = 0;
};

// A goal out of its time takes no floor.
template <class M>
std::vector<FloorHolder> floor_holders(const Timeline& timeline, const Stream<M>& goals, double age) {
  std::vector<FloorHolder> holders;
  double held = -1e9;
  std::int64_t now = 0;
  auto truth = timeline.base_truth.begin();
  for (const auto& goal : goals) {
    for (; truth != timeline.base_truth.end() && truth->t <= goal.t; ++truth) now = truth->message.utime;
    if (now > 0 && std::abs(seconds_between(goal.message.utime, now)) > age + kStampsApart_s) continue;
    const bool other = holders.empty() || goal.message.session != holders.back().session;
    if (other && goal.world - held <= age) continue;
    if (other) holders.push_back({goal.world, goal.message.session});
    held = goal.world;
  }
  return holders;
}

// Whether `session` had the floor at some time within [from, to].
inline bool had_the_floor(const std::vector<FloorHolder>& holders, std::int64_t session, double from, double to) {
  for (std::size_t i = 0; i < holders.size(); ++i) {
    const double until = i + 1 < holders.size() ? holders[i + 1].from : to;
    if (holders[i].session == session && holders[i].from <= to && until >= from) return true;
  }
  return false;
}

}  // namespace markservo::campaign
