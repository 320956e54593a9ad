#include "services/base-navigator/goal_memory.hpp"

#include <gtest/gtest.h>

namespace markservo::base_navigator {
namespace {

using Heard = GoalMemory::Heard;

constexpr std::int64_t kNow = 1'700'000'000'000'000;
constexpr double kGoalAge_s = 0.6;

Goal goal_of(std::int64_t session, std::int64_t id, std::int64_t utime = kNow) {
  Goal goal;
  goal.session = session;
  goal.id = id;
  goal.utime = utime;
  return goal;
}

Heard hear(GoalMemory& goals, const Goal& goal, std::int64_t now = kNow) {
  return goals.hear(goal, now, kGoalAge_s, false);
}

TEST(GoalMemory, AGoalIsNewOnceHoweverTwoWritersAlternate) {
  GoalMemory goals;
  EXPECT_EQ(hear(goals, goal_of(1, 1)), Heard::kNew);
  EXPECT_EQ(hear(goals, goal_of(2, 1, kNow + 1)), Heard::kNew);
  for (int i = 1; i <= 20; ++i) {
    const std::int64_t now = kNow + std::int64_t{200'000} * i;
    EXPECT_EQ(hear(goals, goal_of(1, 1, now), now), Heard::kIgnored);
    EXPECT_EQ(hear(goals, goal_of(2, 1, now + 1), now), Heard::kAgain);
  }
  EXPECT_EQ(goals.goal()->session, 2);
}

TEST(GoalMemory, AnotherWritersReplacedGoalStaysReplacedAfterThePresentOneAgedOut) {
  GoalMemory goals;
  hear(goals, goal_of(1, 1));
  hear(goals, goal_of(2, 1));
  const std::int64_t later = kNow + 5'000'000;
  EXPECT_EQ(hear(goals, goal_of(1, 1, later), later), Heard::kIgnored);
  EXPECT_EQ(hear(goals, goal_of(1, 2, later), later), Heard::kNew);
}

TEST(GoalMemory, AnotherWritersOlderGoalIsTakenOnlyOnceThePresentOneHasAgedOut) {
  GoalMemory goals;
  hear(goals, goal_of(1, 1, kNow));
  EXPECT_EQ(hear(goals, goal_of(2, 1, kNow - 100'000), kNow), Heard::kIgnored);
  // The clock went back by ten minutes, and both writer and navigator's odometry with it.
  const std::int64_t back = kNow - 600'000'000;
  EXPECT_EQ(hear(goals, goal_of(2, 1, back), back), Heard::kNew);
}

TEST(GoalMemory, ATimeFarAheadDoesNotOutliveTheNextRepetition) {
  GoalMemory goals;
  hear(goals, goal_of(1, 1, kNow + 600'000'000));
  EXPECT_EQ(hear(goals, goal_of(1, 1, kNow)), Heard::kAgain);
  EXPECT_EQ(goals.goal()->utime, kNow);
  hear(goals, goal_of(1, 1, kNow - 50'000));  // a late one
  EXPECT_EQ(goals.goal()->utime, kNow);
}

TEST(GoalMemory, WhatAStopHasEndedStaysEnded) {
  GoalMemory goals;
  hear(goals, goal_of(1, 4));
  goals.end();
  EXPECT_EQ(hear(goals, goal_of(1, 4)), Heard::kIgnored);
  EXPECT_EQ(hear(goals, goal_of(1, 3)), Heard::kIgnored);
  EXPECT_EQ(goals.hear(goal_of(1, 5), kNow, kGoalAge_s, true), Heard::kIgnored);
  EXPECT_EQ(hear(goals, goal_of(1, 5)), Heard::kIgnored);
  EXPECT_EQ(hear(goals, goal_of(1, 6)), Heard::kNew);
}

}  // namespace
}  // namespace markservo::base_navigator
