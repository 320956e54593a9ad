// What is watched in any phase, each watch by itself.

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>

#include "services/task-manager/watches/arm_session.hpp"
#include "services/task-manager/watches/condition_timer.hpp"
#include "services/task-manager/watches/holding.hpp"
#include "services/task-manager/watches/servo_watch.hpp"
#include "services/task-manager/watches/stop_watch.hpp"

namespace markservo::task_manager {
namespace {

constexpr std::int64_t kSecond = 1'000'000;  // us
constexpr double kTimeout = 3.0;             // s
constexpr double kWidth = 0.025;             // m
const StopReport kReleased{true, false, ""};
const StopReport kLatched{true, true, "arm: why"};
const StopReport kSilent{false, false, "", false, "arm"};

ArmReport arm_of(std::int64_t session) {
  ArmReport report;
  report.session = session;
  return report;
}

TEST(ConditionTimer, BeginsAnewAfterABreak) {
  ConditionTimer timer;
  EXPECT_EQ(timer.observe(true, 5 * kSecond), 0.0);
  EXPECT_DOUBLE_EQ(timer.observe(true, 7 * kSecond), 2.0);
  EXPECT_EQ(timer.observe(false, 8 * kSecond), 0.0);
  EXPECT_EQ(timer.observe(true, 9 * kSecond), 0.0);
}

TEST(ArmSession, RestartsOnceForEachNewSession) {
  ArmSession session;
  EXPECT_FALSE(session.restarts(std::nullopt));
  EXPECT_FALSE(session.restarts(arm_of(7)));
  EXPECT_TRUE(session.restarts(arm_of(8)));
  EXPECT_FALSE(session.restarts(arm_of(8)));
}

TEST(StopWatch, EndsWhatIsUnderWayOrHeldUpAndNothingElse) {
  for (const Phase phase : {Phase::kServo, Phase::kHoldLifted}) {
    StopWatch watch;
    const auto ending = watch.observe(kLatched, phase, false);
    ASSERT_TRUE(ending) << name_of(phase);
    EXPECT_EQ(ending->phase, Phase::kStopped);
    EXPECT_EQ(ending->reason, "stop: arm: why");
  }
  EXPECT_FALSE(StopWatch().observe(kLatched, Phase::kDone, false));
}

TEST(StopWatch, RefusesATaskThatWaitsForAFirstWordOfALatchedDevice) {
  StopWatch watch;
  EXPECT_FALSE(watch.observe(kSilent, Phase::kDrive, true));
  const auto ending = watch.observe(kLatched, Phase::kDrive, true);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->phase, Phase::kRefused);
}

TEST(StopWatch, LetsATaskGoOnThatWaitedForAFirstWordOfAStopThatIsResetByNow) {
  StopReport reset = kReleased;
  reset.meanwhile = true;
  StopWatch watch;
  EXPECT_FALSE(watch.observe(kSilent, Phase::kLook, true));
  EXPECT_FALSE(watch.observe(reset, Phase::kLook, true));
  EXPECT_TRUE(watch.was_reset());
  EXPECT_TRUE(StopWatch().observe(reset, Phase::kServo, false)) << "one at work does not";
}

TEST(StopWatch, EndsATaskWhenADeviceFallsSilentButNotALook) {
  StopWatch at_work;
  EXPECT_FALSE(at_work.observe(kReleased, Phase::kServo, false));
  EXPECT_TRUE(at_work.observe(kSilent, Phase::kServo, false));
  StopWatch looking;
  EXPECT_FALSE(looking.observe(kReleased, Phase::kLook, false));
  EXPECT_FALSE(looking.observe(kSilent, Phase::kLook, false));
}

TEST(StopWatch, SaysOnceThatAStopWasReset) {
  StopWatch watch;
  watch.observe(kLatched, Phase::kStopped, false);
  EXPECT_FALSE(watch.was_reset());
  watch.observe(kReleased, Phase::kStopped, false);
  EXPECT_TRUE(watch.was_reset());
  watch.observe(kReleased, Phase::kStopped, false);
  EXPECT_FALSE(watch.was_reset());
}

// What the watch says of `servo` that lasts a little longer than the timeout.
std::optional<Ending> after_the_timeout(const ServoReport& servo, bool moving = true, std::int64_t goal_id = 1) {
  ServoWatch watch;
  EXPECT_FALSE(watch.observe(servo, moving, goal_id, 0, kTimeout));
  EXPECT_FALSE(watch.observe(servo, moving, goal_id, 3 * kSecond, kTimeout));
  return watch.observe(servo, moving, goal_id, 3 * kSecond + 1, kTimeout);
}

TEST(ServoWatch, EndsATaskByWhatLasts) {
  EXPECT_FALSE(after_the_timeout({1, ServoState::kServo, false, ""}));
  const auto stale = after_the_timeout({1, ServoState::kStale, false, "why"});
  ASSERT_TRUE(stale);
  EXPECT_EQ(stale->phase, Phase::kFailed);
  EXPECT_EQ(stale->reason, "the arm holds for want of fresh input: why");
  const auto stopped = after_the_timeout({1, ServoState::kStopped, false, "why"});
  ASSERT_TRUE(stopped);
  EXPECT_EQ(stopped->phase, Phase::kStopped);
  EXPECT_EQ(stopped->reason, "visual-servo is stopped: why");
}

TEST(ServoWatch, TellsSilenceAboutTheGoalBeforeWhatElseLasts) {
  const auto unheard = after_the_timeout({0, ServoState::kStale, false, "why"});
  ASSERT_TRUE(unheard);
  EXPECT_EQ(unheard->phase, Phase::kFailed);
  EXPECT_EQ(unheard->reason, "visual-servo does not answer the goal: why");
  EXPECT_TRUE(after_the_timeout({7, ServoState::kServo, false, ""})) << "another goal was told in our name";
  EXPECT_FALSE(after_the_timeout({0, ServoState::kHold, false, ""}, true, 0)) << "no goal was sent";
}

TEST(ServoWatch, WatchesOnlyWhatMoves) {
  EXPECT_FALSE(after_the_timeout({0, ServoState::kStale, false, ""}, false));
}

class FullHand : public ::testing::Test {
 protected:
  FullHand() { holding_.grip(arm_, kWidth); }

  ArmReport arm_{7, {0.1, 0.2, 0.3}, kWidth};
  Holding holding_;
};

TEST_F(FullHand, HoldsUntilItWasToldToOpen) {
  EXPECT_TRUE(holding_.holds_on(arm_));
  EXPECT_TRUE(holding_.over_place());
  holding_.observe_command(0.010);
  EXPECT_TRUE(holding_.holds_on(arm_));
  holding_.observe_command(0.050);
  EXPECT_FALSE(holding_.holds_on(arm_));
  EXPECT_TRUE(holding_.something()) << "nobody knows";
}

TEST_F(FullHand, MayNotPutBackWhatWasCarriedAway) {
  holding_.carry_away();
  EXPECT_TRUE(holding_.something());
  EXPECT_FALSE(holding_.over_place());
}

TEST_F(FullHand, LosesWhatItHoldsWhenTheArmIsElsewhereOrAnotherOrTheHandIsOpen) {
  ArmReport elsewhere = arm_;
  elsewhere.q[1] += 0.21;
  ArmReport another = arm_;
  another.session = 8;
  ArmReport open = arm_;
  open.gripper_opening = kWidth + 0.007;
  for (const ArmReport& arm : {elsewhere, another, open}) {
    Holding holding = holding_;
    EXPECT_TRUE(holding.loses(arm, false));
    EXPECT_FALSE(holding.something());
    EXPECT_FALSE(holding.loses(arm, false)) << "once";
  }
  EXPECT_FALSE(holding_.loses(arm_, false));
  EXPECT_FALSE(holding_.loses(std::nullopt, false));
}

TEST_F(FullHand, GoesWhereTheArmGoesForATask) {
  arm_.q[1] += 1.0;
  EXPECT_FALSE(holding_.loses(arm_, true));
  EXPECT_FALSE(holding_.loses(arm_, false));
}

}  // namespace
}  // namespace markservo::task_manager
