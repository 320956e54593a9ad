#include "common/robot/workspace.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markservo::robot {
namespace {

class Workspace : public ::testing::Test {
 protected:
  GripJudgement judge(double x, double y) const {
    return judge_grip(robot_, *robot_.find_mark("red_book"), {x, y, 0.032});
  }

  RobotDescription robot_ = load_robot_description(MARKSERVO_SOURCE_DIR "/config/robot.yaml");
};

TEST_F(Workspace, MiddleBookBeforeTheArmIsFeasible) {
  EXPECT_EQ(judge(0.0325, 0.25).verdict, GripVerdict::kFeasible);
  EXPECT_EQ(judge(0.0325, 0.25).reason, "");
}

TEST_F(Workspace, DistanceOf35CentimetresIsBeyondReach) {
  EXPECT_EQ(judge(0.0325, 0.35).verdict, GripVerdict::kUnreachable);
  EXPECT_EQ(judge(0.0325, 0.35).reason, "beyond the arm's reach: 0.414 m from the shoulder; allowed: 0.000 to 0.400 m");
}

TEST_F(Workspace, UnreachableWinsOverOutOfView) {
  EXPECT_EQ(judge(-0.15, 0.35).verdict, GripVerdict::kUnreachable);
}

TEST_F(Workspace, TooCloseForBothCamerasIsOutOfView) {
  EXPECT_EQ(judge(0.0325, 0.10).verdict, GripVerdict::kOutOfView);
}

TEST_F(Workspace, FingersNeedRoomBetweenTheBooks) {
  auto& marks = robot_.marks;
  for (auto& mark : marks) {
    if (mark.grip) mark.grip->spacing = 0.040;
  }
  EXPECT_EQ(judge(0.0325, 0.25).verdict, GripVerdict::kUnreachable);
  EXPECT_NE(judge(0.0325, 0.25).reason.find("room"), std::string::npos);
}

TEST_F(Workspace, OfTheDefaultRobotHoldsAFairShareOfThePapersGrid) {
  int feasible = 0;
  for (const double middle_x : {-0.10, -0.05, 0.0, 0.05, 0.10}) {
    for (const double offset : {-0.05, 0.0, 0.05}) {
      for (const double y : {0.35, 0.30, 0.25, 0.20, 0.15}) {
        feasible += judge(middle_x + offset, y).verdict == GripVerdict::kFeasible ? 1 : 0;
      }
    }
  }
  EXPECT_GE(feasible, 15);
}

TEST_F(Workspace, NeedsAnArmAndAGrip) {
  EXPECT_THROW(judge_grip(robot_, *robot_.find_mark("hand"), {0.0, 0.25, 0.0}), std::invalid_argument);
  RobotDescription no_arm = robot_;
  no_arm.arm.reset();
  EXPECT_THROW(judge_grip(no_arm, *robot_.find_mark("red_book"), {0.0, 0.25, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::robot
