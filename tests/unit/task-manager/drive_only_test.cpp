// DRIVE: to a place, and nothing to take there.

#include <gtest/gtest.h>

#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

const geometry::PlanePose kDock{0.2, 1.05, M_PI / 2};

TEST(DriveOnly, BringsTheRobotThereAndTakesNothing) {
  FakeRobot robot;
  robot.base_pose.y = 0.05;
  robot.run_for(0.5);
  robot.send_drive_only(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kDone)) << name_of(robot.last().phase) << ": " << robot.last().reason;
  EXPECT_EQ(robot.phases(), (std::vector<Phase>{Phase::kIdle, Phase::kDrive, Phase::kDone}));
  EXPECT_EQ(robot.last().reason, "arrived");
  EXPECT_EQ(robot.last().target, "");
  EXPECT_NEAR(robot.way_of_base(), 1.0, 1e-6);
  EXPECT_FALSE(robot.drive_goal().drive);
  EXPECT_EQ(robot.reckless(), "");
}

TEST(DriveOnly, IsRefusedAsAnyDriveIs) {
  FakeRobot off_the_tags;
  off_the_tags.send_drive_only({50.0, 0.0, 0.0});
  ASSERT_TRUE(off_the_tags.run_until(Phase::kRefused, 1.0));
  EXPECT_NE(off_the_tags.last().reason.find("leaves the floor's tags"), std::string::npos);

  FakeRobot holding;
  holding.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(holding.run_until(Phase::kHoldLifted));
  holding.send_drive_only(kDock);
  ASSERT_TRUE(holding.run_until(Phase::kRefused, 1.0));
  EXPECT_EQ(holding.way_of_base(), 0.0);

  robot::RobotDescription description = default_robot();
  description.base.reset();
  FakeRobot without_base(description);
  without_base.send_drive_only(kDock);
  ASSERT_TRUE(without_base.run_until(Phase::kRefused, 1.0));
}

TEST(DriveOnly, IsEndedByAbort) {
  FakeRobot robot;
  robot.base_pose.y = 0.05;
  robot.run_for(0.5);
  robot.send_drive_only(kDock);
  robot.run_for(1.0);
  robot.send(CommandKind::kAbort);
  ASSERT_TRUE(robot.run_until(Phase::kStopped, 1.0));
  const double way = robot.way_of_base();
  robot.run_for(2.0);
  EXPECT_NEAR(robot.way_of_base(), way, 1e-9);
}

}  // namespace
}  // namespace markservo::task_manager
