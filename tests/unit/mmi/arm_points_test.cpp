#include "services/mmi/scene/arm_points.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "common/robot/arm_kinematics.hpp"
#include "services/mmi/scene/camera_pose.hpp"

namespace markservo::mmi {
namespace {

const std::vector<robot::JointVector> kPostures = {
    {0.0, 0.0, 0.0}, {0.0, 2.1, -2.6}, {0.7, 1.2, -0.9}, {-1.5, -0.08, -2.7}, {1.5, 2.7, 0.0}};

class ArmPointsOf : public ::testing::Test {
 protected:
  robot::RobotDescription robot_ = robot::load_robot_description(MARKSERVO_SOURCE_DIR "/config/robot.yaml");
};

TEST_F(ArmPointsOf, TheCamerasLookAlongTheRobotsX) {
  robot_.cameras.p_RC = {0.1, 0.2, 0.7};
  const Eigen::Isometry3d X_RC = camera_pose(robot_.cameras);
  EXPECT_EQ(X_RC * Eigen::Vector3d(0.0, 1.0, 0.0), Eigen::Vector3d(1.1, 0.2, 0.7));   // forward
  EXPECT_EQ(X_RC * Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(0.1, -0.8, 0.7));  // right
  EXPECT_EQ(X_RC * Eigen::Vector3d(0.0, 0.0, 1.0), Eigen::Vector3d(0.1, 0.2, 1.7));   // up
}

TEST_F(ArmPointsOf, TheGripPointIsThatOfTheKinematics) {
  robot_.arm->yaw_CA = 0.3;
  for (const robot::JointVector& q : kPostures) {
    const Eigen::Vector3d expected = camera_pose(robot_.cameras) * robot::grip_point(*robot_.arm, q);
    EXPECT_LT((arm_points(robot_, q)[3] - expected).norm(), 1e-12) << q.transpose();
  }
}

TEST_F(ArmPointsOf, TheSegmentsAreAsLongAsTheLinks) {
  robot_.arm->yaw_CA = 0.3;
  robot_.arm->forearm = 0.23;  // another length than the upper arm's
  for (const robot::JointVector& q : kPostures) {
    const ArmPoints points = arm_points(robot_, q);
    EXPECT_NEAR((points[1] - points[0]).norm(), robot_.arm->column, 1e-12);
    EXPECT_NEAR((points[2] - points[1]).norm(), robot_.arm->upper_arm, 1e-12);
    EXPECT_NEAR((points[3] - points[2]).norm(), robot_.arm->forearm, 1e-12);
  }
}

TEST_F(ArmPointsOf, TheColumnStandsUprightOnTheArmsFoot) {
  const ArmPoints points = arm_points(robot_, kPostures[2]);
  // p_RC + (p_CA's y, minus its x, its z).
  EXPECT_TRUE(points[0].isApprox(Eigen::Vector3d(0.16, 0.0, 0.25), 1e-12)) << points[0].transpose();
  EXPECT_TRUE(points[1].isApprox(Eigen::Vector3d(0.16, 0.0, 0.40), 1e-12)) << points[1].transpose();
}

TEST_F(ArmPointsOf, StretchedForwardTheElbowIsAheadOfTheShoulder) {
  const ArmPoints points = arm_points(robot_, {0.0, 0.0, 0.0});
  EXPECT_TRUE(points[2].isApprox(Eigen::Vector3d(0.36, 0.0, 0.40), 1e-12)) << points[2].transpose();
}

TEST_F(ArmPointsOf, ARobotWithoutAnArmHasNone) {
  robot_.arm.reset();
  EXPECT_THROW(arm_points(robot_, kPostures[0]), std::invalid_argument);
  ArmView view(robot_);
  view.observe(JointReport{false, 1, kPostures[0]});
  EXPECT_TRUE(view.json().is_null());
  EXPECT_EQ(view.version(), 0u);
}

TEST_F(ArmPointsOf, TheViewTellsTheNewestMeasuredAndCommandedPosture) {
  ArmView view(robot_);
  view.observe(JointReport{true, 6, kPostures[1]});
  EXPECT_TRUE(view.json().is_null()) << "it is not known yet where the arm is";
  view.observe(JointReport{false, 5, kPostures[0]});
  view.observe(JointReport{false, 7, kPostures[2]});
  const auto json = view.json();
  EXPECT_EQ(json["utime"], "7");
  EXPECT_EQ(json["measured"][3][2], arm_points(robot_, kPostures[2])[3].z());
  EXPECT_EQ(json["commanded"][3][2], arm_points(robot_, kPostures[1])[3].z());
  EXPECT_EQ(view.version(), 3u);
}

TEST_F(ArmPointsOf, TheViewTellsNoCommandBeforeTheFirst) {
  ArmView view(robot_);
  view.observe(JointReport{false, 5, kPostures[0]});
  EXPECT_TRUE(view.json()["commanded"].is_null());
  EXPECT_EQ(view.json()["measured"].size(), 4u);
}

}  // namespace
}  // namespace markservo::mmi
