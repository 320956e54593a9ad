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
    const double opening = robot.goal().opening;
    robot.stop = {true, true, "arm: stop from test"};
    robot.frame();
    EXPECT_EQ(robot.last().phase, Phase::kStopped);
    EXPECT_EQ(robot.last().reason, "stop: arm: stop from test");
    EXPECT_EQ(robot.goal().kind, GoalKind::kHold);
    EXPECT_EQ(robot.goal().opening, opening) << "the gripper keeps what it holds";

    const double way = robot.way_of_joints();
    const std::int64_t goal_before = robot.goal().id;
    robot.stop = {true, false, ""};
    robot.run_for(3.0);
    EXPECT_EQ(robot.last().phase, Phase::kStopped);
    EXPECT_EQ(robot.way_of_joints(), way) << "a reset never resumes";
    EXPECT_GT(robot.goal().id, goal_before) << "what was sent before the reset is not obeyed any more";
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
