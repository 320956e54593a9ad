// Where the robot may be told to drive.

#include "services/task-manager/plans/drive_field.hpp"

#include <gtest/gtest.h>

#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

TEST(DriveField, OffTheFloorsTagsADriveIsRefusedAtOnceWithWhatIsAllowed) {
  for (const geometry::PlanePose& pose : {geometry::PlanePose{5.0, 5.0, 0.0}, {0.2, -3.0, -M_PI / 2}}) {
    FakeRobot robot;
    robot.run_for(0.5);
    robot.send_drive(pose);
    ASSERT_TRUE(robot.run_until(Phase::kRefused, 1.0)) << robot.last().reason;
    EXPECT_NE(robot.last().reason.find("allowed on field course: x -0.10 to 0.50 m, y -0.10 to 1.20 m"),
              std::string::npos)
        << robot.last().reason;
    EXPECT_EQ(robot.way_of_base(), 0.0);
  }
}

TEST(DriveField, ReachesAsFarAsTheReaderReads) {
  const robot::RobotDescription robot = default_robot();
  EXPECT_EQ(why_off_the_field(robot, "", {-0.09, 1.19, 0.0}), "");
  EXPECT_NE(why_off_the_field(robot, "", {-0.11, 1.0, 0.0}), "");
  EXPECT_EQ(why_off_the_field(robot, "hall", {3.0, 3.0, 0.0}), "");
}

}  // namespace
}  // namespace markservo::task_manager
