// The table of conflict_guard.hpp, walked through.

#include "common/motion/conflict_guard.hpp"

#include <gtest/gtest.h>

namespace markservo::motion {
namespace {

constexpr std::int64_t kNow = 1'000'000'000;
using State = ConflictGuard::State;

TEST(ConflictGuard, IsQuietUntilTwoClaimToBeOne) {
  ConflictGuard guard;
  EXPECT_FALSE(guard.active());
  EXPECT_FALSE(guard.due(kNow));
  EXPECT_FALSE(guard.hear_stop_state(false, true));
}

TEST(ConflictGuard, AsksForAStopAtOnceAndAtFiveHertzUntilItIsLatched) {
  ConflictGuard guard;
  guard.raise("two write JOINT_STATE");
  ASSERT_TRUE(guard.due(kNow));
  EXPECT_FALSE(guard.due(kNow + 199'000));
  const auto again = guard.due(kNow + 200'000);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->id, 1);
  EXPECT_EQ(again->reason, "two write JOINT_STATE");
  guard.hear_stop_state(true, false);
  EXPECT_EQ(guard.state(), State::kStopped);
  EXPECT_FALSE(guard.due(kNow + 1'000'000));
}

TEST(ConflictGuard, AStopThatWasLatchedBeforeIsAskedForAllTheSame) {
  ConflictGuard guard;
  guard.raise("two");
  guard.hear_stop_state(true, false);
  EXPECT_TRUE(guard.due(kNow));
}

TEST(ConflictGuard, ARunningMoverDoesNotEndIt) {
  ConflictGuard guard;
  guard.raise("two");
  guard.due(kNow);
  EXPECT_FALSE(guard.hear_stop_state(false, true)) << "that it is released was said before the stop";
  EXPECT_TRUE(guard.active());
}

TEST(ConflictGuard, EndsWithALaterResetOnceOneIsAlone) {
  ConflictGuard guard;
  guard.raise("two");
  guard.due(kNow);
  guard.hear_stop_state(true, false);
  EXPECT_TRUE(guard.hear_stop_state(false, true));
  EXPECT_FALSE(guard.active());
  EXPECT_EQ(guard.why(), "");
}

TEST(ConflictGuard, AResetWhileTwoSpeakIsAnsweredWithAnotherStop) {
  ConflictGuard guard;
  guard.raise("two");
  guard.due(kNow);
  guard.hear_stop_state(true, false);
  EXPECT_FALSE(guard.hear_stop_state(false, false));
  const auto stop = guard.due(kNow + 10'000);
  ASSERT_TRUE(stop);
  EXPECT_EQ(stop->id, 2) << "the first one was executed";
}

TEST(ConflictGuard, KeepsTheFirstReason) {
  ConflictGuard guard;
  guard.raise("first");
  guard.raise("second");
  EXPECT_EQ(guard.why(), "first");
}

}  // namespace
}  // namespace markservo::motion
