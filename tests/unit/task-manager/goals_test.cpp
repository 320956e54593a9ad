// When arm and base are told their goals.

#include "services/task-manager/goals.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace markservo::task_manager {
namespace {

constexpr std::int64_t kNow = 1'000'000'000;  // us

TEST(ArmGoals, AreNoneBeforeTheFirst) {
  ArmGoals goals;
  EXPECT_TRUE(goals.none_yet());
  EXPECT_FALSE(goals.due(kNow));
}

TEST(ArmGoals, AreSentWhenNewAndEvery200msUnderOneId) {
  ArmGoals goals;
  goals.set(Goal());
  ASSERT_TRUE(goals.due(kNow));
  EXPECT_FALSE(goals.due(kNow + 199'999));
  const auto again = goals.due(kNow + 200'000);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->id, 1);
  goals.set(Goal());
  const auto next = goals.due(kNow + 210'000);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->id, 2);
  EXPECT_FALSE(goals.due(kNow + 400'000)) << "the new one began a new period";
}

TEST(ArmGoals, AreSentAtOnceWhenTheClockWasSetBack) {
  ArmGoals goals;
  goals.set(Goal());
  goals.due(kNow);
  EXPECT_TRUE(goals.due(kNow - 1));
}

TEST(ArmGoals, AreSetAnewWhenTheyAreIgnoredForMoreThanASecond) {
  ArmGoals goals;
  goals.insist(true, kNow);
  goals.insist(true, kNow + 2'000'000);
  EXPECT_TRUE(goals.none_yet()) << "what was never told cannot be ignored";
  Goal goal;
  goal.opening = 0.02;
  goals.set(goal);
  goals.insist(true, kNow + 3'000'000);
  goals.insist(true, kNow + 4'000'000);
  EXPECT_EQ(goals.newest().id, 1);
  goals.insist(true, kNow + 4'000'001);
  EXPECT_EQ(goals.newest().id, 2);
  EXPECT_EQ(goals.newest().opening, 0.02);
  goals.insist(true, kNow + 4'100'000);
  goals.insist(true, kNow + 5'100'000);
  EXPECT_EQ(goals.newest().id, 2) << "the new one has a second of its own";
  goals.insist(false, kNow + 5'100'001);
  goals.insist(true, kNow + 5'200'000);
  goals.insist(true, kNow + 6'200'000);
  EXPECT_EQ(goals.newest().id, 2) << "it was heard meanwhile";
}

TEST(BaseGoals, HoldUnderOneIdUntilTheBaseWasToldToDrive) {
  BaseGoals goals;
  goals.hold();
  goals.hold();
  EXPECT_EQ(goals.newest().id, 1);
  DriveGoal drive;
  drive.drive = true;
  goals.set(drive);
  goals.hold();
  EXPECT_EQ(goals.newest().id, 3);
  EXPECT_FALSE(goals.newest().drive);
}

}  // namespace
}  // namespace markservo::task_manager
