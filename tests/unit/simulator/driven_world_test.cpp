// The world with its base on the move.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/simulator/test_world.hpp"

namespace markservo::simulator {
namespace {

using Eigen::Vector3d;

// Drives evenly speeding up and slowing down from `from` by `way` along its heading (m; below 0: backwards).
geometry::PlanePose drive(World& world, const geometry::PlanePose& from, double way) {
  constexpr double kAcceleration = 0.8;  // m/s2, the robot's own
  constexpr double kSpeed = 0.4;         // m/s
  double done = 0.0;
  double speed = 0.0;
  geometry::PlanePose pose = from;
  while (done < std::abs(way)) {
    const double stoppable = std::sqrt(2.0 * kAcceleration * (std::abs(way) - done));
    speed = std::min({speed + kAcceleration * kTimeStep, kSpeed, std::max(stoppable, 0.002)});
    done = std::min(done + speed * kTimeStep, std::abs(way));
    const double along = std::copysign(done, way);
    pose = {from.x + along * std::cos(from.heading), from.y + along * std::sin(from.heading), from.heading};
    world.move_base(pose);
    world.step();
  }
  return pose;
}

geometry::PlanePose dock() {
  return test_scene().dock.X_WD();
}

// Grips the red book and lifts it by 3 cm.
void take_the_book(World& world) {
  const Vector3d goal = Vector3d(0.0325, 0.25, 0.032) + test_robot().find_mark("red_book")->grip->p_TG;
  const Vector3d before = goal + Vector3d(0.0, -0.07, 0.0);
  const auto ik = robot::inverse_kinematics(*test_robot().arm, before, 0.0);
  ASSERT_EQ(ik.status, robot::ReachStatus::kReachable);
  world.command(posture(ik.q, 0.05));
  wait(world, 2.0);
  ASSERT_TRUE(move_straight(world, before, goal, 0.05));
  world.command(posture(world.arm().position, 0.0));
  wait(world, 1.0);
  ASSERT_TRUE(move_straight(world, goal, goal + Vector3d(0.0, 0.0, 0.03), 0.0));
}

TEST(DrivenWorld, ARobotOneMetreBeforeTheDockHasTheBooksOneMetreFartherAway) {
  World world = test_world(test_settings({{"base.start_y", 0.05}}));
  const MarkTruth mark = mark_of(world.truth(), "red_book");
  EXPECT_LT((mark.p_CM - Vector3d(0.0325, 1.25, 0.032)).norm(), 5e-5);
  EXPECT_LT((mark.normal_C - Vector3d(0.0, -1.0, 0.0)).norm(), 1e-3);
}

TEST(DrivenWorld, ARobotThatTurnsLeftHasTheBooksFartherRight) {
  World world = test_world(test_settings({{"base.start_heading_deg", 120.0}}));
  // The mark is 0.35 m ahead of R's origin, which is 0.10 m behind C's and 0.0325 m to its right.
  const double turn = M_PI / 6.0;
  const Vector3d expected(0.0325 + 0.35 * std::sin(turn), -0.10 + 0.35 * std::cos(turn), 0.032);
  EXPECT_LT((mark_of(world.truth(), "red_book").p_CM - expected).norm(), 5e-5);
}

TEST(DrivenWorld, TheArmStaysAsItIsWhileItsBaseDrives) {
  World world = test_world(test_settings({{"base.start_y", 0.05}}));
  const WorldTruth before = world.truth();
  geometry::PlanePose pose{0.20, 0.05, dock().heading};
  for (int i = 0; i < 10; ++i) {
    pose = drive(world, pose, 0.05);
    EXPECT_LT((world.truth().p_CG - before.p_CG).norm(), 2e-5);
    EXPECT_LT((world.truth().shaft - before.shaft).cwiseAbs().maxCoeff(), 1e-4);
  }
  EXPECT_NEAR(mark_of(world.truth(), "red_book").p_CM.y(), 0.75, 1e-4);
}

TEST(DrivenWorld, BooksStandStillWhileTheRobotDrives) {
  World world = test_world(test_settings());
  drive(world, dock(), -0.5);
  const WorldTruth truth = world.truth();
  EXPECT_LT((mark_of(truth, "red_book").p_CM - Vector3d(0.0325, 0.75, 0.032)).norm(), 1e-4);
  for (const auto& book : truth.bodies) EXPECT_NEAR(book.height_gain, 0.0, 1e-4);
}

TEST(DrivenWorld, TheGripHoldsAfterAWayOfOneMetreAndBack) {
  World world = test_world(test_settings());
  drive(world, drive(world, dock(), -1.0), 1.0);
  take_the_book(world);
  wait(world, 0.5);
  const WorldTruth truth = world.truth();
  const BodyTruth& book = body_of(truth, "red_book");
  EXPECT_GE(book.height_gain, 0.020);
  EXPECT_TRUE(book.touches_left_finger && book.touches_right_finger);
  EXPECT_FALSE(book.touches_other);
}

TEST(DrivenWorld, AGrippedBookIsCarriedAlong) {
  World world = test_world(test_settings());
  take_the_book(world);
  wait(world, 0.5);
  const Vector3d held = body_of(world.truth(), "red_book").X_CB.translation();
  geometry::PlanePose pose = drive(world, dock(), -0.4);
  for (int i = 0; i < 500; ++i) {
    pose.heading += 0.0005;
    world.move_base(pose);
    world.step();
  }
  wait(world, 0.5);
  const WorldTruth truth = world.truth();
  EXPECT_LT((body_of(truth, "red_book").X_CB.translation() - held).norm(), 0.004);
  EXPECT_TRUE(body_of(truth, "red_book").touches_left_finger);
  EXPECT_GT((body_of(truth, "blue_book").X_CB.translation() - held).norm(), 0.3) << "the others stayed behind";
}

TEST(DrivenWorld, TheSameDriveGivesTheSameWorldBitForBit) {
  const auto run = [] {
    World world = test_world(test_settings());
    world.command(posture({0.3, 1.4, -1.1}, 0.01));
    drive(world, dock(), -0.3);
    return world.truth();
  };
  const WorldTruth first = run();
  const WorldTruth second = run();
  EXPECT_EQ(first.p_CG, second.p_CG);
  EXPECT_EQ(first.bodies[0].X_CB.matrix(), second.bodies[0].X_CB.matrix());
}

TEST(DrivenWorld, TheDockedOutlineKeepsItsDistanceFromCabinetAndTable) {
  World world = test_world(test_settings());
  // The cabinet's front is 4 cm behind the board's edge, which is 0.4 cm before the spines at 25 cm; the outline
  // reaches 22 - 10 cm beyond the lenses.
  EXPECT_NEAR(world.clearance(), 0.25 - 0.004 + 0.04 - 0.12, 1e-9);
}

TEST(DrivenWorld, ClearanceShrinksToNothingAtTheCabinet) {
  World world = test_world(test_settings());
  geometry::PlanePose pose = drive(world, dock(), 0.10);
  EXPECT_NEAR(world.clearance(), 0.066, 1e-9);
  drive(world, pose, 0.07);
  EXPECT_EQ(world.clearance(), 0.0);
}

TEST(DrivenWorld, AnObstacleAppearsAndLeavesAtOnce) {
  World world = test_world(test_settings({{"base.start_y", 0.05}}));
  const double without = world.clearance();
  const std::vector<Ray> ahead = {{{0.22, 0.0, 0.25}, {1.0, 0.0, 0.0}}};
  const double free_way = *world.cast_rays(ahead)[0];
  Settings settings = test_settings({{"base.start_y", 0.05},
                                     {"obstacle.present", 1.0},
                                     {"obstacle.x", 0.2},
                                     {"obstacle.y", 0.85},
                                     {"obstacle.size", 0.4}});
  world.change(settings);
  ASSERT_TRUE(world.cast_rays(ahead)[0].has_value());
  EXPECT_NEAR(*world.cast_rays(ahead)[0], 0.85 - 0.2 - 0.27, 1e-9);
  EXPECT_NEAR(world.clearance(), 0.85 - 0.2 - 0.27, 1e-9);
  settings.obstacle.present = 0.0;
  world.change(settings);
  EXPECT_NEAR(*world.cast_rays(ahead)[0], free_way, 1e-9);
  EXPECT_NEAR(world.clearance(), without, 1e-9);
}

TEST(DrivenWorld, RaysMeetTheCabinetAndNotTheRobotItself) {
  World world = test_world(test_settings());
  const auto ways = world.cast_rays({{{0.0, 0.0, 0.15}, {1.0, 0.0, 0.0}}, {{0.0, 0.0, 0.15}, {-1.0, 0.0, 0.0}}});
  ASSERT_TRUE(ways[0].has_value());
  EXPECT_NEAR(*ways[0], 0.22 + 0.166, 1e-9);
  EXPECT_FALSE(ways[1].has_value()) << "nothing stands behind it";
}

}  // namespace
}  // namespace markservo::simulator
