#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/fault_campaign/forged_history.hpp"

namespace markservo::campaign {
namespace {

constexpr auto kStands = [](double) { return 0.0; };
// From 3 s to 4 s at 0.1 rad/s or m/s.
constexpr auto kMoves = [](double t) { return 0.1 * std::clamp(t - 3.0, 0.0, 1.0); };

TEST(SilenceIsRest, HoldsWhileCommandsComeAndAtRestWithout) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kMoves).joint_commands(0.5, 4.0).base_commands(0.5, 4.0);
  const Verdict verdict = silence_is_rest(forged.timeline(), forged_bars());
  EXPECT_GT(verdict.judged, 10);
  EXPECT_FALSE(verdict.broken());
}

TEST(SilenceIsRest, BreaksWhenTheArmGoesOnWithoutCommands) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).joint_commands(0.5, 3.0);
  EXPECT_TRUE(silence_is_rest(forged.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, BreaksWhenTheBaseGoesOnWithoutCommands) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kStands, [](double t) { return 0.1 * std::clamp(t - 3.0, 0.0, 4.0); }).base_commands(0.5, 3.0);
  EXPECT_TRUE(silence_is_rest(forged.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, BreaksForAMotionThatNobodyEverCommanded) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands);
  EXPECT_TRUE(silence_is_rest(forged.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, TakesNoCommandForFreshThatAnswersAnOldMeasurement) {
  ForgedHistory fresh;
  fresh.world(0.0, 8.0, kMoves, kStands).joint_commands(0.5, 4.5, 0.0, 1.0, {kServo, kSimulator, 0.25});
  EXPECT_FALSE(silence_is_rest(fresh.timeline(), forged_bars()).broken());
  ForgedHistory old;
  old.world(0.0, 8.0, kMoves, kStands).joint_commands(0.5, 4.5, 0.0, 1.0, {kServo, kSimulator, 0.4});
  EXPECT_TRUE(silence_is_rest(old.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, TakesNoCommandForFreshThatWasMadeForAnotherMover) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).joint_commands(0.5, 4.5, 0.0, 1.0, {kServo, 55});
  EXPECT_TRUE(silence_is_rest(forged.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, TakesNoCommandForFreshThatLeapsAway) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).joint_commands(0.5, 4.5, 1.5, 1.0, {kStranger});
  EXPECT_TRUE(silence_is_rest(forged.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, LetsAStrangerCommandWhoWritesAlone) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kMoves).joint_commands(0.5, 2.0).base_commands(0.5, 2.0);
  forged.joint_commands(2.5, 4.5, 0.0, 1.0, {kStranger}).base_commands(2.5, 4.5, 0.0, {kStranger});
  EXPECT_FALSE(silence_is_rest(forged.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, BreaksWhenAStrangerUnderTheStacksOwnSessionIsObeyed) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).joint_commands(0.5, 2.0);
  forged.joint_commands(2.1, 4.5, 0.0, 1.0, {kServo, kSimulator, 0.0, true});
  EXPECT_TRUE(silence_is_rest(forged.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, BreaksWhenAMoverGoesOnWhileTwoWriteItsCommands) {
  ForgedHistory arm;
  arm.world(0.0, 8.0, kMoves, kStands).joint_commands(0.5, 4.5);
  arm.joint_commands(2.03, 4.5, 0.0, 1.0, {kStranger});
  EXPECT_TRUE(silence_is_rest(arm.timeline(), forged_bars()).broken());
  ForgedHistory base;
  base.world(0.0, 8.0, kStands, kMoves).base_commands(0.5, 4.5).base_commands(2.03, 4.5, 0.0, {kStranger});
  EXPECT_TRUE(silence_is_rest(base.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, LetsAMoverGoOnThatAResetReleasedAfterTwoWrote) {
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).joint_commands(0.2, 4.5).stop_state(0.1, "arm", false, 3);
  forged.joint_commands(0.53, 0.7, 0.0, 1.0, {kStranger}).stop_state(0.8, "arm", true, 3);
  forged.stop_state(2.0, "arm", false, 4);
  EXPECT_FALSE(silence_is_rest(forged.timeline(), forged_bars()).broken());
}

TEST(SilenceIsRest, TakesNoLateCopyForASecondWriter) {
  // Each command once more, 10 ms late: as it was, so that nobody new speaks.
  ForgedHistory forged;
  forged.world(0.0, 8.0, kMoves, kStands).joint_commands(0.5, 4.5);
  forged.joint_commands_again(0.01);
  EXPECT_FALSE(silence_is_rest(forged.timeline(), forged_bars()).broken());
}

}  // namespace
}  // namespace markservo::campaign
