#include "services/simulator/world/world.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/degrees.hpp"
#include "tests/unit/simulator/test_world.hpp"

namespace markservo::simulator {
namespace {

using geometry::kRadiansPerDegree;

TEST(World, BooksStandWhereTheSettingsSay) {
  World world = test_world(test_settings({{"books.x", 0.05}, {"books.y", 0.30}}));
  const WorldTruth truth = world.truth();
  EXPECT_LT((mark_of(truth, "red_book").p_CM - Eigen::Vector3d(0.05, 0.30, 0.032)).norm(), 5e-5);
  EXPECT_LT((mark_of(truth, "yellow_book").p_CM - Eigen::Vector3d(0.10, 0.30, 0.032)).norm(), 5e-5);
  EXPECT_LT((mark_of(truth, "blue_book").p_CM - Eigen::Vector3d(0.0, 0.30, 0.032)).norm(), 5e-5);
  EXPECT_LT((mark_of(truth, "red_book").normal_C - Eigen::Vector3d(0.0, -1.0, 0.0)).norm(), 1e-3);
}

TEST(World, SlantTurnsEachBookAboutItsMark) {
  World world = test_world(test_settings({{"books.slant_deg", 20.0}}));
  const MarkTruth mark = mark_of(world.truth(), "red_book");
  EXPECT_LT((mark.p_CM - Eigen::Vector3d(0.0325, 0.25, 0.032)).norm(), 5e-5);
  const double slant = 20.0 * kRadiansPerDegree;
  EXPECT_LT((mark.normal_C - Eigen::Vector3d(std::sin(slant), -std::cos(slant), 0.0)).norm(), 1e-3);
}

TEST(World, TheArmIsWhereTheKinematicsSay) {
  const robot::ArmDescription arm = *test_robot().arm;
  World world = test_world(test_settings({{"books.y", 0.8}}));
  for (const robot::JointVector& q : {robot::JointVector(0.0, 1.5, -1.0), robot::JointVector(0.6, 1.2, -0.7)}) {
    world.command(posture(q, 0.03, 5.0));
    wait(world, 1.0);
    const WorldTruth truth = world.truth();
    EXPECT_LT((truth.shaft - q).norm(), 1e-4);
    EXPECT_LT((truth.p_CG - robot::grip_point(arm, q)).norm(), 1e-4);
    const Eigen::Isometry3d X_CM = robot::hand_mark_pose(arm, q);
    EXPECT_LT((mark_of(truth, "hand").p_CM - X_CM.translation()).norm(), 1e-4);
    EXPECT_LT((mark_of(truth, "hand").normal_C + X_CM.linear().col(1)).norm(), 1e-3);
    EXPECT_NEAR(truth.gripper_opening, 0.03, 1e-4);
  }
}

TEST(World, CalibrationErrorsMoveTheTrueArmOnly) {
  const robot::JointVector q(0.0, 1.5, -1.0);
  World world = test_world(test_settings(
      {{"books.y", 0.8}, {"calibration.arm_x", 0.01}, {"calibration.arm_yaw_deg", 3.0}, {"arm.link_scale", 1.02}}));
  world.command(posture(q, 0.05, 5.0));
  wait(world, 1.0);
  robot::ArmDescription arm = *test_robot().arm;
  EXPECT_GT((world.truth().p_CG - robot::grip_point(arm, q)).norm(), 0.005);
  arm.p_CA.x() += 0.01;
  arm.yaw_CA += 3.0 * kRadiansPerDegree;
  for (double* length : {&arm.column, &arm.upper_arm, &arm.forearm}) *length *= 1.02;
  EXPECT_LT((world.truth().p_CG - robot::grip_point(arm, q)).norm(), 1e-4);
  EXPECT_LT((world.arm().position - q).norm(), 1e-9);
}

TEST(World, TheSameSeedGivesTheSameWorldBitForBit) {
  const auto run = [] {
    World world = test_world(test_settings({{"servo.deadband_deg", 0.3}}), 5);
    world.command(posture({0.3, 1.4, -1.1}, 0.01));
    wait(world, 0.7);
    return world.truth();
  };
  const WorldTruth first = run();
  const WorldTruth second = run();
  EXPECT_EQ(first.shaft, second.shaft);
  EXPECT_EQ(first.p_CG, second.p_CG);
  EXPECT_EQ(first.bodies[0].X_CB.matrix(), second.bodies[0].X_CB.matrix());
}

TEST(World, JointLimitsHold) {
  World world = test_world(test_settings({{"books.y", 0.8}}));
  const robot::JointVector home = test_robot().arm->home;
  world.command(posture({3.0, home[1], home[2]}, 1.0, 10.0));
  wait(world, 2.0);
  EXPECT_NEAR(world.truth().shaft[0], test_robot().arm->joints[0].max, 1e-3);
  EXPECT_LE(world.arm().gripper_opening, 0.05);
}

TEST(World, FreezingStopsTheArmAtOnce) {
  World world = test_world(test_settings());
  world.command(posture({0.0, 1.2, -1.5}, 0.05, 1.0));
  wait(world, 0.2);
  ASSERT_TRUE(world.arm().moving);
  world.freeze();
  const robot::JointVector there = world.truth().shaft;
  wait(world, 1.0);
  EXPECT_LT((world.truth().shaft - there).cwiseAbs().maxCoeff(), 0.3 * kRadiansPerDegree);
  EXPECT_FALSE(world.arm().moving);
}

TEST(World, TellsTheFirstThingThatTheArmTouched) {
  World world = test_world(test_settings());
  EXPECT_FALSE(world.truth().arm_touched);
  const auto ik = robot::inverse_kinematics(*test_robot().arm, {0.0325, 0.24, -0.139}, 0.0);
  ASSERT_EQ(ik.status, robot::ReachStatus::kReachable);
  world.command(posture(ik.q, 0.05, 2.0));
  wait(world, 2.0);
  const WorldTruth truth = world.truth();
  EXPECT_TRUE(truth.arm_touched);
  EXPECT_NE(truth.touched.find(" - "), std::string::npos);
}

TEST(World, NobodyTouchesAnythingAtHome) {
  World world = test_world(test_settings());
  wait(world, 1.0);
  const WorldTruth truth = world.truth();
  EXPECT_FALSE(truth.arm_touched) << truth.touched;
  for (const auto& body : truth.bodies) {
    EXPECT_NEAR(body.height_gain, 0.0, 1e-5);
    EXPECT_FALSE(body.touches_left_finger || body.touches_right_finger);
    EXPECT_TRUE(body.touches_other) << "it stands on the shelf";
  }
}

TEST(World, ABookThatIsPushedOverNeverGainsEnergy) {
  World world = test_world(test_settings());
  const robot::ArmDescription arm = *test_robot().arm;
  const auto before = robot::inverse_kinematics(arm, {0.058, 0.20, 0.0}, 0.0);
  const auto through = robot::inverse_kinematics(arm, {-0.03, 0.27, 0.0}, 0.0);
  ASSERT_EQ(before.status, robot::ReachStatus::kReachable);
  ASSERT_EQ(through.status, robot::ReachStatus::kReachable);
  world.command(posture(before.q, 0.0, 5.0));
  wait(world, 1.0);
  world.command(posture(through.q, 0.0, 1.0));
  wait(world, 3.0);
  for (const auto& body : world.truth().bodies) {
    EXPECT_LT(body.height_gain, 0.05) << body.name;
    EXPECT_LT(body.X_CB.translation().norm(), 1.5) << body.name;
  }
}

}  // namespace
}  // namespace markservo::simulator
