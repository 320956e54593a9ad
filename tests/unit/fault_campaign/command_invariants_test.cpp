#include <gtest/gtest.h>

#include "tests/unit/fault_campaign/forged_history.hpp"

namespace markservo::campaign {
namespace {

// A book hangs in the hand from 2 s on; at 3 s the fingers open.
ForgedHistory opening_hand() {
  ForgedHistory forged;
  const SimBody book = held_book(0.05);
  forged.still(0.0, 2.0);
  for (double t = 2.0; t < 5.0; t += 0.1) {
    forged.base_at(t, 0.0);
    forged.arm_at(t, 0.0, &book, t < 3.0 ? 0.025 : 0.045, "finger_left - red_book");
  }
  return forged;
}

TEST(HandKeepsWhatItLifted, HoldsWhenItIsTheRelease) {
  ForgedHistory forged = opening_hand();
  forged.task_state(1.9, TaskState::LIFT_ON).task_state(2.9, TaskState::RELEASE);
  const Verdict verdict = hand_keeps_what_it_lifted(forged.timeline(), forged_bars());
  EXPECT_GT(verdict.judged, 5);
  EXPECT_FALSE(verdict.broken());
}

TEST(HandKeepsWhatItLifted, BreaksWhenNothingAskedForIt) {
  ForgedHistory forged = opening_hand();
  forged.task_state(1.9, TaskState::HOLD_LIFTED);
  EXPECT_TRUE(hand_keeps_what_it_lifted(forged.timeline(), forged_bars()).broken());
}

TEST(HandKeepsWhatItLifted, TakesDoneForARelease) {
  ForgedHistory released = opening_hand();
  released.task_state(1.8, TaskState::LIFT_ON).task_state(1.9, TaskState::GO_HOME).task_state(2.4, TaskState::DONE);
  EXPECT_FALSE(hand_keeps_what_it_lifted(released.timeline(), forged_bars()).broken());
  ForgedHistory forged = opening_hand();
  forged.task_state(1.9, TaskState::LIFT_ON).task_state(2.4, TaskState::DONE);
  EXPECT_TRUE(hand_keeps_what_it_lifted(forged.timeline(), forged_bars()).broken());
}

TEST(TouchesOnlyTheTarget, BreaksForASecondTouchAfterTheTargets) {
  // The first touch since the reset stays told; what the fingers touch now is told of each body.
  ForgedHistory forged = opening_hand();
  SimBody other = held_book(0.0);
  other.name = "book_left";
  forged.start(0.5).task_state(1.8, TaskState::GRIP).arm_at(5.1, 0.0, &other, 0.03, "finger_left - red_book");
  EXPECT_TRUE(touches_only_the_target(forged.timeline(), forged_bars()).broken());
}

TEST(TouchesOnlyTheTarget, BreaksForABodyThatWasMoved) {
  ForgedHistory forged;
  SimBody other = held_book(0.0);
  other.name = "book_left";
  other.touches_left_finger = other.touches_right_finger = 0;
  forged.start(0.1);
  for (double t = 0.0; t < 4.0; t += 0.1) {
    forged.base_at(t, 0.0);
    other.height_gain = t < 3.0 ? 0.0 : 0.01;
    forged.arm_at(t, 0.0, &other);
  }
  EXPECT_TRUE(touches_only_the_target(forged.timeline(), forged_bars()).broken());
}

TEST(TouchesOnlyTheTarget, HoldsForFingersThatGrip) {
  ForgedHistory forged = opening_hand();
  forged.start(0.5).task_state(1.8, TaskState::GRIP);
  const Verdict verdict = touches_only_the_target(forged.timeline(), forged_bars());
  EXPECT_GT(verdict.judged, 10);
  EXPECT_FALSE(verdict.broken());
}

TEST(TouchesOnlyTheTarget, BreaksForFingersThatTouchBeforeTheGrip) {
  ForgedHistory forged = opening_hand();
  forged.start(0.5).task_state(0.6, TaskState::SERVO);
  EXPECT_TRUE(touches_only_the_target(forged.timeline(), forged_bars()).broken());
}

TEST(TouchesOnlyTheTarget, BreaksForAnythingElse) {
  ForgedHistory forged;
  forged.still(0.0, 2.0)
      .start(0.5)
      .task_state(1.0, TaskState::GRIP)
      .arm_at(2.0, 0.0, nullptr, 0.03, "finger_left - book_left");
  EXPECT_TRUE(touches_only_the_target(forged.timeline(), forged_bars()).broken());
}

TEST(TouchesOnlyTheTarget, BreaksWhenTheBaseRunsIntoSomething) {
  ForgedHistory forged;
  forged.still(0.0, 2.0).base_at(2.0, 0.0, true);
  EXPECT_TRUE(touches_only_the_target(forged.timeline(), forged_bars()).broken());
}

TEST(CommandsAreWithinLimits, HoldsForCommandsNearTheShafts) {
  ForgedHistory forged;
  forged.still(0.0, 3.0).joint_commands(0.5, 2.5, 0.3, 1.0).base_commands(0.5, 2.5, 1.2);
  const Verdict verdict = commands_are_within_limits(forged.timeline(), forged_bars());
  EXPECT_GT(verdict.judged, 10);
  EXPECT_FALSE(verdict.broken());
}

TEST(CommandsAreWithinLimits, BreaksForALeap) {
  ForgedHistory forged;
  forged.still(0.0, 3.0).joint_commands(0.5, 2.5, 0.5, 1.0);
  EXPECT_TRUE(commands_are_within_limits(forged.timeline(), forged_bars()).broken());
}

TEST(CommandsAreWithinLimits, AsksNoLeadOfACommandThatIsTooOldToBeObeyed) {
  CommandWriter after_a_hang;
  after_a_hang.age = 0.4;
  ForgedHistory forged;
  forged.still(0.0, 3.0).joint_commands(1.0, 2.5, 0.5, 1.0, after_a_hang);
  EXPECT_FALSE(commands_are_within_limits(forged.timeline(), forged_bars()).broken());
  ForgedHistory outside;
  outside.still(0.0, 3.0).joint_commands(1.0, 2.5, 1.6, 1.0, after_a_hang);
  EXPECT_TRUE(commands_are_within_limits(outside.timeline(), forged_bars()).broken());
}

TEST(CommandsAreWithinLimits, BreaksBeyondAJointsLimits) {
  ForgedHistory angle;
  angle.joint_commands(0.5, 2.5, 1.6, 1.0);
  EXPECT_TRUE(commands_are_within_limits(angle.timeline(), forged_bars()).broken());
  ForgedHistory speed;
  speed.joint_commands(0.5, 2.5, 0.0, 5.1);
  EXPECT_TRUE(commands_are_within_limits(speed.timeline(), forged_bars()).broken());
}

TEST(CommandsAreWithinLimits, BreaksForABaseThatIsTooFast) {
  ForgedHistory forged;
  forged.base_commands(0.5, 2.5, 1.3);
  EXPECT_TRUE(commands_are_within_limits(forged.timeline(), forged_bars()).broken());
}

TEST(CommandsAreWithinLimits, BreaksForAnArmThatLeavesItsLimitsWhoeverCommandsIt) {
  ForgedHistory forged;
  forged.world(
      0.0, 4.0, [](double t) { return t; }, [](double) { return 0.0; });
  EXPECT_TRUE(commands_are_within_limits(forged.timeline(), forged_bars()).broken());
}

TEST(CommandsAreWithinLimits, BreaksForAnArmThatLeaps) {
  ForgedHistory forged;
  forged.world(
      0.0, 4.0, [](double t) { return t < 2.0 ? 0.0 : 0.5; }, [](double) { return 0.0; });
  EXPECT_TRUE(commands_are_within_limits(forged.timeline(), forged_bars()).broken());
}

TEST(CommandsAreWithinLimits, BreaksForABaseThatIsTrulyTooFast) {
  ForgedHistory forged;
  forged.base_at(1.0, 0.0, false, 0.0, 1.3);
  EXPECT_TRUE(commands_are_within_limits(forged.timeline(), forged_bars()).broken());
}

TEST(ReleaseNeedsAFreshReset, HoldsForAResetOfThisMoment) {
  ForgedHistory forged;
  forged.still(0.0, 3.0).stop_state(1.0, "arm", true).reset(1.5, 7, 1.0).stop_state(1.6, "arm", false, 7);
  const Verdict verdict = release_needs_a_fresh_reset(forged.timeline(), forged_bars());
  EXPECT_EQ(verdict.judged, 1);
  EXPECT_FALSE(verdict.broken());
}

TEST(ReleaseNeedsAFreshReset, BreaksForOneThatIsATenthTooOld) {
  ForgedHistory forged;
  forged.still(0.0, 5.0).stop_state(1.0, "arm", true).reset(3.0, 7, 1.0).stop_state(3.0, "arm", false, 7);
  EXPECT_FALSE(release_needs_a_fresh_reset(forged.timeline(), forged_bars()).broken());
  ForgedHistory older;
  older.still(0.0, 5.0).stop_state(1.0, "arm", true).reset(3.0, 7, 1.0).stop_state(3.1, "arm", false, 7);
  EXPECT_TRUE(release_needs_a_fresh_reset(older.timeline(), forged_bars()).broken());
}

TEST(ReleaseNeedsAFreshReset, BreaksForAnOldOne) {
  ForgedHistory forged;
  forged.still(0.0, 3.0).stop_state(1.0, "arm", true).reset(1.5, 7, -2280.0).stop_state(1.6, "arm", false, 7);
  EXPECT_TRUE(release_needs_a_fresh_reset(forged.timeline(), forged_bars()).broken());
}

TEST(ReleaseNeedsAFreshReset, BreaksForOneFromTheFuture) {
  ForgedHistory forged;
  forged.still(0.0, 3.0).stop_state(1.0, "arm", true).reset(1.5, 7, 3600.0).stop_state(1.6, "arm", false, 7);
  EXPECT_TRUE(release_needs_a_fresh_reset(forged.timeline(), forged_bars()).broken());
}

TEST(ReleaseNeedsAFreshReset, BreaksWithoutAny) {
  ForgedHistory forged;
  forged.still(0.0, 3.0).stop_state(1.0, "arm", true).stop_state(1.6, "arm", false);
  EXPECT_TRUE(release_needs_a_fresh_reset(forged.timeline(), forged_bars()).broken());
}

}  // namespace
}  // namespace markservo::campaign
