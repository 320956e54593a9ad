// A stop freezes the gripper, and no reset makes it go on: only a new goal does.

#include "tests/unit/visual-servo/rig.hpp"

namespace markservo::visual_servo::test {
namespace {

constexpr double kSame = 1e-9;  // m

class GripperStop : public Rig {
 protected:
  void tell_gripper(double opening, std::int64_t id) {
    Goal goal = posture_goal(start_, id);
    goal.gripper_opening = opening;
    machine_.observe(goal, state_);
  }

  // Stopped for 0.5 s and reset; the opening at which it froze.
  double stop_and_reset() {
    frame();
    stop(true);
    frame();
    const double frozen = arm_.opening;
    frames(15);
    EXPECT_NEAR(arm_.opening, frozen, kSame);
    stop(false);
    return frozen;
  }
};

TEST_F(GripperStop, StoppedWhileClosingItDoesNotCloseOn) {
  tell_gripper(0.01, 1);
  frames(6);
  ASSERT_LT(arm_.opening, 0.045);
  ASSERT_GT(arm_.opening, 0.02);
  const double frozen = stop_and_reset();
  frames(30);
  EXPECT_NEAR(arm_.opening, frozen, kSame);
  tell_gripper(0.01, 2);
  frames(30);
  EXPECT_NEAR(arm_.opening, 0.01, kSame) << "a new goal closes it";
}

TEST_F(GripperStop, StoppedWhileOpeningItDoesNotOpenOn) {
  tell_gripper(0.01, 1);
  frames(30);
  tell_gripper(0.05, 2);
  frames(6);
  ASSERT_LT(arm_.opening, 0.045);
  const double frozen = stop_and_reset();
  frames(30);
  EXPECT_NEAR(arm_.opening, frozen, kSame);
}

TEST_F(GripperStop, StoppedAndResetBetweenTwoPicturesItDoesNotGoOnEither) {
  tell_gripper(0.01, 1);
  frames(6);
  stop(true);
  stop(false);
  frame();  // of the old command
  const double opening = arm_.opening;
  frames(30);
  EXPECT_NEAR(arm_.opening, opening, 0.1 / 30.0 + kSame);
}

TEST_F(GripperStop, WhatWasPressedOnIsNotDropped) {
  arm_.object_width = 0.025;
  tell_gripper(0.01, 1);
  frames(40);
  ASSERT_NEAR(arm_.opening, 0.025, kSame);
  stop_and_reset();
  const Output output = frames(30);
  EXPECT_NEAR(output.command->gripper_opening, 0.01, kSame);
  EXPECT_NEAR(output.command->gripper_force, 10.0, kSame);
}

TEST_F(GripperStop, AGoalThatIsNotRepeatedClosesItNoFurther) {
  frames(20);
  Goal goal = posture_goal(start_, 1);
  goal.gripper_opening = 0.0;
  goal.utime -= 450'000;  // 0.15 s before it is too old
  sender_lives_ = false;
  machine_.observe(goal, state_);
  frames(10);
  const double opening = arm_.opening;
  EXPECT_GT(opening, 0.02);
  frames(30);
  EXPECT_NEAR(arm_.opening, opening, kSame);
}

TEST_F(GripperStop, ACloseThatHasJustBeenToldIsNoPress) {
  frames(20);
  tell_gripper(0.01, 1);
  frame();  // commanded, but the arm has not begun
  machine_.observe_stop(true, "", state_);
  arm_.stopped = true;
  frames(5);
  const double frozen = arm_.opening;
  stop(false);
  frames(30);
  EXPECT_NEAR(arm_.opening, frozen, kSame);
}

TEST_F(GripperStop, AHandThatWasPutElsewhereMeanwhileIsNotClosed) {
  arm_.object_width = 0.025;
  tell_gripper(0.01, 1);
  frames(40);
  stop(true);
  frames(3);
  arm_.object_width = 0.0;  // the world was reset
  arm_.opening = 0.05;
  frames(3);
  stop(false);
  frames(30);
  EXPECT_NEAR(state_.command.gripper_opening, 0.05, 0.002);
  EXPECT_NEAR(arm_.opening, 0.05, 0.002);
}

}  // namespace
}  // namespace markservo::visual_servo::test
