#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/fault_campaign/forged_history.hpp"

namespace markservo::campaign {
namespace {

constexpr auto kStands = [](double) { return 0.0; };
// From 3 s to 4 s at 0.1 rad/s or m/s.
constexpr auto kMoves = [](double t) { return 0.1 * std::clamp(t - 3.0, 0.0, 1.0); };

TEST(LatchedIsStill, HoldsForARobotThatRests) {
  ForgedHistory forged;
  forged.still(0.0, 8.0).stop_state(1.0, "arm", true).stop_state(1.0, "base", true);
  const Verdict verdict = latched_is_still(forged.timeline(), forged_bars());
  EXPECT_GT(verdict.judged, 1);
  EXPECT_FALSE(verdict.broken());
}

TEST(LatchedIsStill, BreaksWhenTheArmMovesUnderALatch) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).stop_state(1.0, "arm", true);
  EXPECT_TRUE(latched_is_still(forged.timeline(), forged_bars()).broken());
}

TEST(LatchedIsStill, BreaksWhenTheBaseMovesUnderALatch) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kStands, kMoves).stop_state(1.0, "base", true);
  EXPECT_TRUE(latched_is_still(forged.timeline(), forged_bars()).broken());
}

TEST(LatchedIsStill, LetsAReleasedRobotMove) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kMoves).stop_state(1.0, "arm", true).stop_state(2.0, "arm", false);
  EXPECT_FALSE(latched_is_still(forged.timeline(), forged_bars()).broken());
}

TEST(LatchedIsStill, LetsTheArmBrake) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).stop_state(3.6, "arm", true);
  EXPECT_FALSE(latched_is_still(forged.timeline(), forged_bars()).broken());
}

TEST(LatchedIsStill, BreaksWhenAStopIsNotObeyed) {
  ForgedHistory obeyed;
  obeyed.still(0.0, 8.0).stop_state(1.0, "arm", false).stop(2.0, 5).stop_state(2.1, "arm", true, 5);
  const Verdict verdict = latched_is_still(obeyed.timeline(), forged_bars());
  EXPECT_GT(verdict.judged, 0);
  EXPECT_FALSE(verdict.broken());
  ForgedHistory late;
  late.still(0.0, 8.0).stop_state(1.0, "arm", false).stop(2.0, 5).stop_state(2.6, "arm", true, 5);
  EXPECT_TRUE(latched_is_still(late.timeline(), forged_bars()).broken());
}

TEST(LatchedIsStill, AsksForNoLatchByAStopThatWasLostOrIsRepeated) {
  ForgedHistory lost;
  lost.still(0.0, 8.0).stop_state(1.0, "arm", false).stop(2.0, 5).fault(1.5, 3.0, {"network"});
  EXPECT_FALSE(latched_is_still(lost.timeline(), forged_bars()).broken());
  ForgedHistory again;
  again.still(0.0, 8.0).stop_state(1.0, "arm", false).stop(2.0, 5).stop_state(2.1, "arm", true, 5);
  again.reset(3.0, 6, 3.0).stop_state(3.1, "arm", false, 6).stop(4.0, 5);
  EXPECT_FALSE(latched_is_still(again.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, HoldsWhileTheGoalIsRepeated) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kMoves).servo_goals(2.8, 4.0).base_goals(2.8, 4.0);
  const Verdict verdict = motion_has_a_goal(forged.timeline(), forged_bars());
  EXPECT_GT(verdict.judged, 10);
  EXPECT_FALSE(verdict.broken());
}

TEST(MotionHasAGoal, BreaksWithoutAGoal) {
  ForgedHistory arm;
  arm.world(0.0, 8.0, kMoves, kStands);
  EXPECT_TRUE(motion_has_a_goal(arm.timeline(), forged_bars()).broken());
  ForgedHistory base;
  base.world(0.0, 8.0, kStands, [](double t) { return 0.1 * std::clamp(t - 3.0, 0.0, 4.0); });
  EXPECT_TRUE(motion_has_a_goal(base.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, BreaksWhenTheArmGoesOnAfterItsLastGoal) {
  ForgedHistory forged;
  forged
      .world(
          0.0, 9.0, [](double t) { return 0.1 * std::clamp(t - 3.0, 0.0, 4.0); }, kStands)
      .servo_goals(2.8, 4.0);
  EXPECT_TRUE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, BreaksWhenASecondSenderIsFollowed) {
  // The first one holds the floor with goals to hold; it is the stranger's that move.
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).servo_goals(1.0, 2.0).servo_goals(2.5, 5.0, kStranger, -3600.0);
  EXPECT_TRUE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, TakesOneWhoWritesAloneForLegal) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).servo_goals(2.5, 4.0, kStranger);
  EXPECT_FALSE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, TakesNoGoalFromAnotherTimeForOne) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).servo_goals(2.8, 4.0, kTask, 3600.0);
  EXPECT_TRUE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, BreaksWhenTheMoverFollowsTheSecondOfTwo) {
  ForgedHistory first;
  first.still(0.0, 6.0).servo_goals(1.0, 5.0).servo_goals(2.05, 5.0, kStranger).follows(4.0, kTask);
  EXPECT_FALSE(motion_has_a_goal(first.timeline(), forged_bars()).broken());
  ForgedHistory second;
  second.still(0.0, 6.0).servo_goals(1.0, 5.0).servo_goals(2.05, 5.0, kStranger).follows(4.0, kStranger);
  EXPECT_TRUE(motion_has_a_goal(second.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, LetsTheNextSpeakWhenTheFirstIsSilent) {
  ForgedHistory forged;
  forged.still(0.0, 6.0).servo_goals(1.0, 2.0).servo_goals(3.0, 5.0, kStranger).follows(4.0, kStranger);
  EXPECT_FALSE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, TakesATaskOfThisMoment) {
  ForgedHistory forged;
  forged.still(0.0, 5.0).start_command(2.0, 7, 1.8).task_state(2.1, TaskState::LOOK, "", 7);
  const Verdict verdict = motion_has_a_goal(forged.timeline(), forged_bars());
  EXPECT_EQ(verdict.judged, 1);
  EXPECT_FALSE(verdict.broken());
}

TEST(MotionHasAGoal, BreaksForATaskThatAnOldStartBegan) {
  ForgedHistory forged;
  forged.still(0.0, 5.0).start_command(2.0, 7, -2280.0).task_state(2.1, TaskState::LOOK, "", 7);
  EXPECT_TRUE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, BreaksForATaskThatNobodyAskedFor) {
  ForgedHistory forged;
  forged.still(0.0, 5.0).task_state(2.1, TaskState::LOOK, "", 7);
  EXPECT_TRUE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
  ForgedHistory lost;
  lost.still(0.0, 5.0).task_state(2.1, TaskState::LOOK, "", 7).fault(1.0, 3.0, {"network"});
  EXPECT_FALSE(motion_has_a_goal(lost.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, AsksForNoCommandThatAStoppedTaskTells) {
  ForgedHistory forged;
  forged.still(0.0, 5.0).task_state(2.1, TaskState::STOPPED, "aborted by operator", 7);
  EXPECT_FALSE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, BreaksWhenAMoverFollowsWhatNobodySent) {
  ForgedHistory forged;
  forged.still(0.0, 6.0).follows(4.0, kStranger);
  EXPECT_TRUE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, AllowsAsMuchBrakingAsTheTrueSpeedNeeds) {
  // The last goal is of 3.8 s: 4.7 s and the braking from 0.1 rad/s or m/s later all stands.
  const auto until = [](double end) { return [end](double t) { return 0.1 * std::clamp(t - 3.0, 0.0, end - 3.0); }; };
  ForgedHistory arm;
  arm.world(0.0, 8.0, until(4.8), kStands).servo_goals(2.8, 4.0);
  EXPECT_FALSE(motion_has_a_goal(arm.timeline(), forged_bars()).broken());
  ForgedHistory late_arm;
  late_arm.world(0.0, 8.0, until(5.05), kStands).servo_goals(2.8, 4.0);
  EXPECT_TRUE(motion_has_a_goal(late_arm.timeline(), forged_bars()).broken());
  ForgedHistory base;
  base.world(0.0, 9.0, kStands, until(4.9)).base_goals(2.8, 4.0);
  EXPECT_FALSE(motion_has_a_goal(base.timeline(), forged_bars()).broken());
  ForgedHistory late_base;
  late_base.world(0.0, 9.0, kStands, until(5.6)).base_goals(2.8, 4.0);
  EXPECT_TRUE(motion_has_a_goal(late_base.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, BreaksWhenTheBaseTurnsWithoutAGoal) {
  ForgedHistory forged;
  for (double t = 0.0; t < 8.0; t += 0.02) forged.base_at(t, 0.0, false, kMoves(t));
  EXPECT_TRUE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, BreaksForMotionLongAfterTwoBeganToCommand) {
  // One of two is obeyed until they are known to be two, and no longer.
  ForgedHistory at_once;
  at_once.world(0.0, 8.0, kStands, kMoves).base_commands(1.0, 5.0).base_commands(3.03, 5.0, 0.0, {kStranger});
  EXPECT_TRUE(motion_has_a_goal(at_once.timeline(), forged_bars()).broken());
  const auto jerks = [](double t) { return 0.1 * std::clamp(t - 3.1, 0.0, 0.2); };
  ForgedHistory jerk;
  jerk.world(0.0, 8.0, kStands, jerks).base_commands(1.0, 5.0).base_commands(3.03, 5.0, 0.0, {kStranger});
  EXPECT_FALSE(motion_has_a_goal(jerk.timeline(), forged_bars()).broken());
}

TEST(MotionHasAGoal, LetsAStrangerDriveWhoCommandsAlone) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kStands, kMoves).base_commands(2.5, 4.2, 0.1, {kStranger});
  EXPECT_FALSE(motion_has_a_goal(forged.timeline(), forged_bars()).broken());
}

TEST(LatchedIsStill, BreaksWhenTheBaseTurnsUnderALatch) {
  ForgedHistory forged;
  forged.stop_state(1.0, "base", true);
  for (double t = 0.0; t < 8.0; t += 0.02) forged.base_at(t, 0.0, false, kMoves(t));
  EXPECT_TRUE(latched_is_still(forged.timeline(), forged_bars()).broken());
}

TEST(WorldClock, StandsWhileTheLastExposureIsToldAgain) {
  WorldClock clock;
  clock.heard(at(0.0), at(0.0));
  clock.heard(at(0.1), at(0.1));
  clock.heard(at(0.15), at(0.04));
  clock.heard(at(0.2), at(0.2));
  EXPECT_NEAR(clock.at(at(0.25)), 0.2, 1e-9);
}

TEST(WorldClock, GoesOnEvenlyWhenTheClockIsSet) {
  WorldClock clock;
  clock.heard(at(0.0), at(0.0));
  clock.heard(at(0.1), at(0.1));
  clock.heard(at(0.2), at(3600.2));
  clock.heard(at(0.3), at(3600.3));
  clock.heard(at(0.4), at(0.4));
  EXPECT_NEAR(clock.at(at(0.45)), 0.4, 1e-9);
}

TEST(WorldClock, IsAsSlowAsTheWorld) {
  WorldClock clock;
  clock.heard(at(0.0), at(0.0));
  clock.heard(at(1.0), at(0.5));
  EXPECT_NEAR(clock.at(at(1.0)), 0.5, 1e-9);
}

}  // namespace
}  // namespace markservo::campaign
