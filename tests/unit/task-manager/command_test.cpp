// Commands: executed once, answered by echo, refused when they do not fit.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

TEST(Command, IsExecutedOnceHoweverOftenItIsRepeated) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  robot.frame();
  EXPECT_EQ(robot.last().command_session, 42);
  EXPECT_EQ(robot.last().command_id, 1);
  for (int i = 0; i < 1200; ++i) {
    robot.send_again();
    robot.frame();
  }
  EXPECT_EQ(robot.last().phase, Phase::kHoldLifted);
  EXPECT_EQ(std::count(robot.phases().begin(), robot.phases().end(), Phase::kLook), 1);
}

TEST(Command, AStartWhileATaskRunsIsAnsweredAndIgnored) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.send(CommandKind::kStart, "blue_book");
  robot.frame();
  EXPECT_EQ(robot.last().command_id, 2);
  EXPECT_EQ(robot.last().target, "red_book");
  ASSERT_EQ(robot.last().notices.size(), 1u);
  EXPECT_NE(robot.last().notices[0].find("START of 'blue_book' ignored"), std::string::npos);
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted));
}

TEST(Command, HomePutsAHeldBookBackFirst) {
  FakeRobot robot;
  const Eigen::Vector3d place = robot.p_CT;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted));
  robot.send(CommandKind::kHome);
  ASSERT_TRUE(robot.run_until(Phase::kDone)) << robot.last().reason;
  EXPECT_FALSE(robot.holds_book());
  EXPECT_LT((robot.p_CT - place).norm(), 0.002);
  EXPECT_LT((robot.q() - default_robot().arm->home).norm(), 1e-6);
  EXPECT_EQ(robot.trespass(), "");
  EXPECT_EQ(robot.last().result, Result::kLifted) << "of the last START";
}

TEST(Command, HomeLeavesTheBooksStraightBeforeItFolds) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kGrip));
  robot.send(CommandKind::kAbort);
  ASSERT_TRUE(robot.run_until(Phase::kStopped, 1.0));
  robot.send(CommandKind::kHome);
  ASSERT_TRUE(robot.run_until(Phase::kDone)) << robot.last().reason;
  EXPECT_EQ(robot.trespass(), "");
}

TEST(Command, StartIsRefusedWhileTheHandHoldsABook) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted));
  robot.send(CommandKind::kStart, "blue_book");
  robot.run_for(2.0);
  EXPECT_EQ(robot.last().phase, Phase::kRefused);
  EXPECT_EQ(robot.last().reason, "the hand holds red_book: task home puts it back");
  EXPECT_TRUE(robot.holds_book());
  robot.send(CommandKind::kHome);
  EXPECT_TRUE(robot.run_until(Phase::kDone)) << robot.last().reason;
}

TEST(Command, HomeIsRefusedWithABookOnTheWayToTheSide) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book", true);
  ASSERT_TRUE(robot.run_until(Phase::kCarry));
  robot.run_for(0.5);
  robot.send(CommandKind::kAbort);
  robot.frame();
  robot.send(CommandKind::kHome);
  robot.run_for(1.0);
  EXPECT_EQ(robot.last().phase, Phase::kStopped);
  EXPECT_NE(robot.last().reason.find("holds red_book away from its place"), std::string::npos);
  EXPECT_TRUE(robot.holds_book());
}

TEST(Command, HomeNeedsAResetStop) {
  FakeRobot robot;
  robot.stop = {true, true, "arm: started"};
  robot.send(CommandKind::kHome);
  ASSERT_TRUE(robot.run_until(Phase::kStopped, 1.0));
  EXPECT_EQ(robot.last().reason, "stop is latched: reset it first (arm: started)");
}

TEST(Command, AbortWithoutATaskChangesNothing) {
  FakeRobot robot;
  robot.send(CommandKind::kAbort);
  robot.frame();
  EXPECT_EQ(robot.last().phase, Phase::kIdle);
  EXPECT_EQ(robot.last().command_id, 1);
}

TEST(Command, AbortEndsATaskThoughItsSenderCountsBadly) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.send_again(CommandKind::kAbort);
  robot.frame();
  EXPECT_EQ(robot.last().phase, Phase::kStopped);
  EXPECT_EQ(robot.last().reason, "aborted by operator");
}

}  // namespace
}  // namespace markservo::task_manager
