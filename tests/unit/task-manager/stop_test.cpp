// STOP, ABORT and restarts end a task in a named state with the arm held, and only a new START begins again.

#include <gtest/gtest.h>

#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

constexpr Phase kBusy[] = {Phase::kLook,   Phase::kApproach, Phase::kServo, Phase::kGrip,    Phase::kLift,
                           Phase::kVerify, Phase::kLiftOn,   Phase::kCarry, Phase::kRelease, Phase::kGoHome};

TEST(Stop, EndsTheTaskInEveryPhase) {
  for (const Phase phase : kBusy) {
    SCOPED_TRACE(name_of(phase));
    FakeRobot robot;
    robot.send(CommandKind::kStart, "red_book", true);
    ASSERT_TRUE(robot.run_until(phase)) << robot.last().reason;
    robot.run_for(0.1);
    if (robot.last().phase != phase) continue;  // it was over before
    const double opening = robot.opening();
    const bool held = robot.holds_book();
    robot.stop = {true, true, "arm: stop from test"};
    robot.frame();
    EXPECT_EQ(robot.last().phase, Phase::kStopped);
    EXPECT_EQ(robot.last().reason, "stop: arm: stop from test");
    EXPECT_EQ(robot.goal().kind, GoalKind::kHold);
    const double way = robot.way_of_joints();
    const std::int64_t goal_before = robot.goal().id;
    robot.stop = {true, false, ""};
    robot.run_for(3.0);
    EXPECT_EQ(robot.last().phase, Phase::kStopped);
    EXPECT_EQ(robot.way_of_joints(), way) << "a reset never resumes";
    EXPECT_EQ(robot.opening(), opening) << "nor does the gripper";
    EXPECT_EQ(robot.holds_book(), held);
    EXPECT_GT(robot.goal().id, goal_before) << "what was sent before the reset is not obeyed any more";
  }
}

TEST(Stop, AGripperThatHeldSomethingGoesOnPressing) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kLiftOn));
  const double pressing = robot.goal().opening;
  robot.stop = {true, true, "arm: stop from test"};
  robot.frame();
  robot.stop = {true, false, ""};
  robot.run_for(1.0);
  EXPECT_EQ(robot.goal().kind, GoalKind::kHold);
  EXPECT_EQ(robot.goal().opening, pressing);
  EXPECT_LT(pressing, robot.opening());
}

// Until it opens, a hand that lets go holds; from then on nobody knows, and it stays as it is.
TEST(Stop, InAReleaseTheHandStaysHalfOpen) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book", true);
  ASSERT_TRUE(robot.run_until(Phase::kRelease));
  while (robot.opening() < 0.028) robot.frame();
  const double opening = robot.opening();
  ASSERT_LT(opening, 0.031) << "still as wide as a held book may be";
  robot.stop = {true, true, "arm: stop"};
  robot.run_for(0.5);
  robot.stop = {true, false, ""};
  robot.run_for(2.0);
  EXPECT_EQ(robot.opening(), opening);
  EXPECT_EQ(robot.goal().opening, opening);
}

TEST(Stop, AStopThatIsResetBetweenTwoStepsEndsTheTaskToo) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.stop.meanwhile = true;
  robot.frame();
  robot.stop.meanwhile = false;
  EXPECT_EQ(robot.last().phase, Phase::kStopped);
  EXPECT_EQ(robot.last().reason, "stop: it is reset by now");
}

TEST(Stop, ADeviceThatFallsSilentEndsATask) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.stop = {false, false, "", false, "arm"};
  robot.frame();
  EXPECT_EQ(robot.last().phase, Phase::kStopped);
  EXPECT_EQ(robot.last().reason, "a stop device is silent: no STOP_STATE of arm");
  robot.send(CommandKind::kHome);
  robot.frame();
  EXPECT_EQ(robot.last().reason, "home: not every stop device answers: no STOP_STATE of arm");
  robot.send(CommandKind::kStart, "red_book");
  robot.run_for(2.0);
  EXPECT_EQ(robot.last().phase, Phase::kLook) << "a START waits for it";
  robot.stop = {true, false, ""};
  EXPECT_TRUE(robot.run_until(Phase::kApproach, 0.1)) << robot.last().reason;
}

TEST(WorldReset, LeavesTheHandOpenAndTheNextTaskDoesNotBeginByClosingIt) {
  for (const bool seen_latched : {true, false}) {
    SCOPED_TRACE(seen_latched);
    FakeRobot robot;
    robot.send(CommandKind::kStart, "red_book");
    ASSERT_TRUE(robot.run_until(Phase::kHoldLifted));
    robot.reset_world();
    robot.stop = {true, seen_latched, "arm: the world was reset", true};
    robot.frame();
    robot.stop = {true, false, ""};
    robot.run_for(1.0);
    EXPECT_EQ(robot.opening(), 0.05);
    robot.send(CommandKind::kStart, "red_book");
    while (robot.frame().phase != Phase::kGrip) {
      ASSERT_EQ(robot.opening(), 0.05) << name_of(robot.last().phase);
      ASSERT_TRUE(under_way(robot.last().phase)) << robot.last().reason;
    }
    EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
  }
}

TEST(Stop, ANewStartAfterTheResetBeginsAgain) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.run_for(0.4);
  robot.stop = {true, true, "arm: stop"};
  ASSERT_TRUE(robot.run_until(Phase::kStopped, 0.1));
  EXPECT_EQ(robot.last().result, Result::kFailed);
  robot.stop = {true, false, ""};
  robot.frame();
  robot.send(CommandKind::kStart, "red_book");
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
  EXPECT_EQ(robot.trespass(), "");
}

TEST(Stop, WhatIsLiftedCountsAsLiftedWhenStoppedLater) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted));
  robot.stop = {true, true, "arm: stop"};
  ASSERT_TRUE(robot.run_until(Phase::kStopped, 0.1));
  EXPECT_EQ(robot.last().result, Result::kLifted);
  EXPECT_TRUE(robot.holds_book());
}

TEST(Stop, AnArmThatRestartsEndsTheTask) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.arm_session = 8;
  robot.frame();
  EXPECT_EQ(robot.last().phase, Phase::kStopped);
  EXPECT_EQ(robot.last().reason, "the arm restarted");
}

TEST(Abort, HoldsWhereTheArmIs) {
  for (const Phase phase : kBusy) {
    SCOPED_TRACE(name_of(phase));
    FakeRobot robot;
    robot.send(CommandKind::kStart, "red_book", true);
    ASSERT_TRUE(robot.run_until(phase)) << robot.last().reason;
    robot.send(CommandKind::kAbort);
    robot.frame();
    EXPECT_EQ(robot.last().phase, Phase::kStopped);
    EXPECT_EQ(robot.last().reason, "aborted by operator");
    const double way = robot.way_of_joints();
    robot.run_for(3.0);
    EXPECT_EQ(robot.way_of_joints(), way);
  }
}

TEST(Restart, ComesUpIdleAndHoldsTheArmWhereItIs) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.restart_task_manager();
  robot.frame();
  EXPECT_EQ(robot.last().phase, Phase::kIdle);
  EXPECT_EQ(robot.last().reason, "started: no task");
  EXPECT_EQ(robot.last().command_id, 0);
  EXPECT_EQ(robot.goal().kind, GoalKind::kHold);
  EXPECT_DOUBLE_EQ(robot.goal().opening, 0.05) << "an open hand stays open";
  const double way = robot.way_of_joints();
  robot.run_for(3.0);
  EXPECT_EQ(robot.way_of_joints(), way);
}

TEST(Restart, TellsTheArmNothingBeforeItsDeviceIsKnown) {
  FakeRobot robot;
  robot.stop = {false, false, ""};
  robot.run_for(1.0);
  EXPECT_EQ(robot.goals_sent(), 0) << "whose report it is may be anyone's";
  robot.stop = {true, false, ""};
  robot.run_for(0.1);
  EXPECT_GT(robot.goals_sent(), 0);
}

TEST(Restart, AHoldThatNobodyAnswersIsSentAnew) {
  FakeRobot robot;
  robot.follows_goals = false;  // a former run of ours had the floor
  robot.run_for(0.9);
  const std::int64_t ignored = robot.goal().id;
  robot.run_for(1.0);
  EXPECT_GT(robot.goal().id, ignored);
  EXPECT_EQ(robot.goal().kind, GoalKind::kHold);
  robot.follows_goals = true;
  robot.run_for(0.1);
  const std::int64_t followed = robot.goal().id;
  robot.run_for(3.0);
  EXPECT_EQ(robot.goal().id, followed);
}

TEST(Restart, AHandThatMayHoldSomethingStaysClosed) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted));
  robot.restart_task_manager();
  robot.run_for(3.0);
  EXPECT_EQ(robot.last().phase, Phase::kIdle);
  EXPECT_TRUE(robot.holds_book());
  EXPECT_EQ(robot.goal().opening, 0.0);
  EXPECT_GT(robot.goal().force, 0.0);
}

}  // namespace
}  // namespace markservo::task_manager
