// The table of goal_inbox.hpp, walked through.

#include "common/motion/goal_inbox.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace markservo::motion {
namespace {

constexpr std::int64_t kStart = 1'000'000'000;
constexpr double kAge = 0.6;  // s

std::int64_t us(double s) {
  return kStart + static_cast<std::int64_t>(1e6 * s);
}

class Goals : public testing::Test {
 protected:
  // A goal that comes at `s`, stamped so.
  GoalHeard hear(std::int64_t session, std::int64_t id, double s, bool latched = false) {
    return inbox_.hear({session, id, us(s)}, us(s), kAge, latched);
  }

  GoalInbox inbox_{"SERVO_GOAL"};
};

TEST_F(Goals, ANewOneIsFollowedAndItsRepetitionsRenewIt) {
  EXPECT_EQ(hear(5, 1, 0.0), GoalHeard::kNew);
  EXPECT_EQ(hear(5, 1, 0.2), GoalHeard::kAgain);
  EXPECT_TRUE(inbox_.fresh(us(0.8), kAge));
  EXPECT_FALSE(inbox_.fresh(us(0.81), kAge));
}

TEST_F(Goals, GrowingIdsReplaceEachOtherAndOldOnesStayEnded) {
  hear(5, 1, 0.0);
  EXPECT_EQ(hear(5, 2, 0.1), GoalHeard::kNew);
  EXPECT_EQ(hear(5, 1, 0.2), GoalHeard::kEnded);
  EXPECT_EQ(inbox_.goal()->id, 2);
}

TEST_F(Goals, OneTooOldOrTooFarAheadIsNotTakenButMayComeFresh) {
  EXPECT_EQ(inbox_.hear({5, 1, us(3600.0)}, us(0.0), kAge, false), GoalHeard::kStale);
  EXPECT_EQ(inbox_.hear({5, 1, us(-0.7)}, us(0.0), kAge, false), GoalHeard::kStale);
  EXPECT_FALSE(inbox_.goal());
  EXPECT_EQ(hear(5, 1, 0.1), GoalHeard::kNew);
}

TEST_F(Goals, ARepetitionFromAnotherTimeKeepsNothingAlive) {
  hear(5, 1, 0.0);
  EXPECT_EQ(inbox_.hear({5, 1, us(3600.0)}, us(0.1), kAge, false), GoalHeard::kStale);
  EXPECT_EQ(inbox_.goal()->utime, us(0.0));
}

TEST_F(Goals, BeforeTheMoverIsHeardTheAgeIsJudgedLater) {
  EXPECT_EQ(inbox_.hear({5, 1, us(0.0)}, 0, kAge, false), GoalHeard::kNew);
  EXPECT_TRUE(inbox_.fresh(us(0.5), kAge));
  EXPECT_FALSE(inbox_.fresh(us(-0.7), kAge));
}

TEST_F(Goals, WhatAStopEndedStaysEnded) {
  hear(5, 1, 0.0);
  inbox_.end();
  EXPECT_EQ(hear(5, 1, 0.2), GoalHeard::kEnded);
  EXPECT_EQ(hear(5, 2, 0.4, true), GoalHeard::kEnded) << "while latched";
  EXPECT_EQ(hear(5, 2, 0.6), GoalHeard::kEnded) << "after the reset";
  EXPECT_EQ(hear(5, 3, 0.8), GoalHeard::kNew);
}

TEST_F(Goals, ASecondSenderIsNamedAndIgnoredWhileTheFirstRepeats) {
  int changes = 0;
  for (int i = 0; i < 50; ++i) {
    changes += hear(5, 1, 0.2 * i) == GoalHeard::kNew ? 1 : 0;
    if (i > 4) {
      EXPECT_EQ(hear(6, 1, 0.2 * i + 0.1), GoalHeard::kSecond);
    }
  }
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(inbox_.second(us(10.0), kAge), "a second one sends SERVO_GOAL: session 6 is not obeyed, 5 is");
  EXPECT_EQ(inbox_.second(us(11.0), kAge), "") << "it is silent";
}

TEST_F(Goals, ARestartedSenderTakesTheFloorWithANewGoalOnceItIsFree) {
  hear(5, 9, 0.0);
  EXPECT_EQ(hear(6, 1, 0.5), GoalHeard::kSecond);
  EXPECT_EQ(hear(6, 2, 0.7), GoalHeard::kNew);
  EXPECT_EQ(inbox_.second(us(0.7), kAge), "");
  EXPECT_EQ(hear(5, 9, 0.8), GoalHeard::kSecond) << "the first has had its turn";
}

TEST_F(Goals, WhatWasIgnoredDoesNotBeginWhenTheFirstFallsSilent) {
  hear(5, 9, 0.0);
  hear(5, 9, 0.5);
  EXPECT_EQ(hear(6, 1, 0.6), GoalHeard::kSecond);
  EXPECT_EQ(hear(6, 1, 1.3), GoalHeard::kEnded);
  EXPECT_EQ(inbox_.goal()->session, 5);
  EXPECT_FALSE(inbox_.fresh(us(1.3), kAge));
  EXPECT_EQ(inbox_.second(us(1.3), kAge),
            "SERVO_GOAL of session 6 was ignored while another sent: it needs a new goal_id");
  EXPECT_EQ(hear(6, 2, 1.4), GoalHeard::kNew);
  EXPECT_EQ(inbox_.second(us(1.4), kAge), "");
}

TEST_F(Goals, WhoOnlyPausedGoesOnThoughAnIgnoredOneRepeats) {
  hear(5, 9, 0.0);
  hear(5, 9, 0.6);
  for (int i = 0; i < 10; ++i) hear(6, 1, 0.7 + 0.2 * i);
  EXPECT_EQ(hear(5, 9, 2.6), GoalHeard::kAgain);
  EXPECT_TRUE(inbox_.fresh(us(2.6), kAge));
  EXPECT_EQ(hear(6, 1, 2.7), GoalHeard::kSecond);
}

TEST_F(Goals, ACrowdOfOthersMakesNothingForgotten) {
  hear(5, 9, 0.0);
  hear(5, 9, 0.5);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(hear(100 + i, 1, 0.8), GoalHeard::kSecond);
  hear(5, 10, 0.9);
  EXPECT_EQ(hear(5, 9, 1.0), GoalHeard::kEnded);
  EXPECT_EQ(inbox_.goal()->id, 10);
}

TEST_F(Goals, SessionZeroIsNobody) {
  EXPECT_EQ(hear(0, 1, 0.0), GoalHeard::kEnded);
  EXPECT_EQ(hear(5, 1, 0.1), GoalHeard::kNew) << "and takes no floor";
}

TEST_F(Goals, WhoCannotKnowWhichOfTwoWasFirstFollowsNone) {
  EXPECT_EQ(hear(5, 1, 0.0), GoalHeard::kNew);
  EXPECT_EQ(hear(6, 1, 0.1), GoalHeard::kSecond);
  EXPECT_EQ(hear(5, 1, 0.2), GoalHeard::kContested);
  EXPECT_FALSE(inbox_.goal());
}

TEST_F(Goals, AnotherBeginningEndsAGoalOfTheFormerTime) {
  hear(5, 1, 0.0);
  EXPECT_FALSE(inbox_.end_unless_fresh(us(0.5), kAge));
  EXPECT_TRUE(inbox_.end_unless_fresh(us(-3600.0), kAge));
  EXPECT_EQ(hear(5, 1, -3599.9), GoalHeard::kEnded);
  EXPECT_EQ(hear(5, 2, -3599.8), GoalHeard::kNew);
}

TEST_F(Goals, OneOfAnotherTimeKeepsNoFloorOnceTheTimeIsKnown) {
  EXPECT_EQ(inbox_.hear({6, 1, us(3600.0)}, 0, kAge, false), GoalHeard::kNew);
  EXPECT_EQ(inbox_.hear({5, 1, us(0.0)}, 0, kAge, false), GoalHeard::kSecond);
  EXPECT_TRUE(inbox_.end_unless_fresh(us(0.1), kAge));
  EXPECT_EQ(hear(5, 1, 0.2), GoalHeard::kNew) << "what was ignored for it is ignored no longer";
}

TEST_F(Goals, AnIdThatNoSenderCountsToMakesItsNextGoalsNoOldOnes) {
  constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(hear(5, kLargest, 0.0), GoalHeard::kBeyond);
  EXPECT_EQ(hear(5, 1, 0.1), GoalHeard::kNew);
  EXPECT_EQ(hear(5, kLargest, 0.2), GoalHeard::kBeyond);
  EXPECT_EQ(inbox_.why_beyond({5, kLargest, 0}),
            "goal_id is 9223372036854775807; allowed from session 5: up to 1000001");
  EXPECT_EQ(hear(5, 1, 0.3), GoalHeard::kAgain);
  EXPECT_EQ(hear(5, 1'000'001, 0.4), GoalHeard::kNew);
  EXPECT_EQ(hear(6, kLargest, 0.5), GoalHeard::kBeyond);
  EXPECT_EQ(hear(5, 1'000'002, 0.6), GoalHeard::kNew) << "the other kept no floor";
}

}  // namespace
}  // namespace markservo::motion
