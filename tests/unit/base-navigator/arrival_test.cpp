// Standing at the goal: when it is judged, and what the verdict is.

#include "services/base-navigator/drive/arrival.hpp"

#include <gtest/gtest.h>

namespace markservo::base_navigator {
namespace {

using Verdict = Arrival::Verdict;

constexpr PoseError kAtGoal{0.01, 0.0};
constexpr PoseError kJustOutside{0.025, 0.0};  // of the tolerance, but coarsely there
constexpr PoseError kBeside{0.10, 0.0};

class StandingAtTheGoal : public testing::Test {
 protected:
  // After `seconds` more of standing with that error.
  Verdict after(double seconds, const PoseError& error) {
    Verdict verdict = Verdict::kWaits;
    for (int i = 0; i < static_cast<int>(seconds / 0.02) + 1 && verdict == Verdict::kWaits; ++i) {
      situation_.utime += 20'000;
      verdict = arrival_.judge(parameters_, situation_, error);
    }
    return verdict;
  }

  // All corrections are used up, each with that error.
  void use_up_corrections(const PoseError& error) {
    for (int i = 0; i < parameters_.corrections; ++i) ASSERT_EQ(after(4.0, error), Verdict::kCorrects) << i;
  }

  ArrivalParameters parameters_;
  Situation situation_ = [] {
    Situation situation;
    situation.utime = 1'700'000'000'000'000;
    situation.position_sigma = 0.005;
    return situation;
  }();
  Arrival arrival_;
};

TEST_F(StandingAtTheGoal, ArrivesOnceItHasStoodForTheSettleTime) {
  EXPECT_EQ(after(0.7, kAtGoal), Verdict::kWaits);
  EXPECT_EQ(after(0.2, kAtGoal), Verdict::kArrived);
}

TEST_F(StandingAtTheGoal, RollingOnBeginsTheSettleTimeAnew) {
  EXPECT_EQ(after(0.7, kAtGoal), Verdict::kWaits);
  situation_.measured.speed = 0.02;
  EXPECT_EQ(after(0.02, kAtGoal), Verdict::kWaits);
  situation_.measured.speed = 0.0;
  EXPECT_EQ(after(0.7, kAtGoal), Verdict::kWaits);
  EXPECT_EQ(after(0.2, kAtGoal), Verdict::kArrived);
}

TEST_F(StandingAtTheGoal, APauseBeginsTheSettleTimeAnew) {
  EXPECT_EQ(after(0.7, kAtGoal), Verdict::kWaits);
  arrival_.interrupt();
  EXPECT_EQ(after(0.7, kAtGoal), Verdict::kWaits);
}

TEST_F(StandingAtTheGoal, AnUnsharpPoseIsLookedAtForLongerButNotForEver) {
  situation_.position_sigma = 0.012;
  EXPECT_EQ(after(2.8, kAtGoal), Verdict::kWaits);
  EXPECT_EQ(after(0.3, kAtGoal), Verdict::kArrived);
}

TEST_F(StandingAtTheGoal, WhatIsJustOutsideWaitsForABetterPoseBeforeItIsCorrected) {
  EXPECT_EQ(after(2.8, kJustOutside), Verdict::kWaits);
  EXPECT_EQ(after(0.3, kJustOutside), Verdict::kCorrects);
  EXPECT_EQ(arrival_.corrections(), 1);
}

TEST_F(StandingAtTheGoal, WhatIsFarOutsideIsCorrectedAtOnce) {
  EXPECT_EQ(after(0.9, kBeside), Verdict::kCorrects);
}

TEST_F(StandingAtTheGoal, TheCoarseToleranceWillDoOnceAllCorrectionsAreUsedUp) {
  use_up_corrections(kBeside);
  EXPECT_EQ(after(4.0, kJustOutside), Verdict::kWillDo);
  EXPECT_EQ(arrival_.why_given_up(), "");
}

TEST_F(StandingAtTheGoal, GivesUpWithBothNumbersWhenTheCoarseToleranceIsMissedToo) {
  use_up_corrections(kBeside);
  EXPECT_EQ(after(4.0, {0.10, 0.1}), Verdict::kGivesUp);
  EXPECT_EQ(arrival_.why_given_up(), "gave up after 4 corrections: 0.100 m and 5.7 degrees off; allowed 0.030 m, 5.0");
}

TEST(HasLeft, OnlyWhoWasMovedByMoreThanArrivingAllows) {
  const ArrivalParameters parameters;
  EXPECT_FALSE(has_left(parameters, {0.04, 0.1}));
  EXPECT_TRUE(has_left(parameters, {0.06, 0.0}));
  EXPECT_TRUE(has_left(parameters, {0.0, -0.2}));
}

}  // namespace
}  // namespace markservo::base_navigator
