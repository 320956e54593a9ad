// Time in which no SERVO_STATUS comes: no goal was repeated, arm and base had to hold, and nobody was late.

#include <gtest/gtest.h>

#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

constexpr double kPause_s = 150.0;  // more than any timeout

TEST(Pause, IsHeldAgainstNoMove) {
  for (const Phase phase : {Phase::kApproach, Phase::kServo, Phase::kLift}) {
    FakeRobot robot;
    robot.run_for(0.5);
    robot.send(CommandKind::kStart, "red_book");
    ASSERT_TRUE(robot.run_until(phase));
    robot.blind_for(kPause_s);
    ASSERT_TRUE(robot.run_until(Phase::kHoldLifted)) << name_of(phase) << ": " << robot.last().reason;
  }
}

TEST(Pause, IsHeldAgainstNoDrive) {
  FakeRobot robot;
  robot.p_CT.y() = 1.25;  // 1 m before the dock
  robot.run_for(0.5);
  robot.send_drive({0.2, 1.05, M_PI / 2});
  ASSERT_TRUE(robot.run_until(Phase::kDrive, 1.0));
  robot.run_for(2.0);
  robot.blind_for(kPause_s);
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted)) << name_of(robot.last().phase) << ": " << robot.last().reason;
}

TEST(Pause, AfterEachFrameStopsNoTimeout) {
  FakeRobot robot;
  robot.run_for(0.5);
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.period_us = 1'500'000;
  robot.hand_sight = Sight::kUnseen;
  EXPECT_TRUE(robot.run_until(Phase::kFailed, 60.0)) << name_of(robot.last().phase) << ": " << robot.last().reason;
}

}  // namespace
}  // namespace markservo::task_manager
