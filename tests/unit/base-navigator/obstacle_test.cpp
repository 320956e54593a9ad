// What stands in the way: stopped for in time, waited for, passed by.

#include <gtest/gtest.h>

#include "tests/unit/base-navigator/rig.hpp"

namespace markservo::base_navigator::test {
namespace {

using geometry::PlanePose;

constexpr double kForever = std::numeric_limits<double>::infinity();

// A box of 20 cm, its front `gap` ahead of the robot's.
std::vector<Wall> box_ahead(const Rig& rig, double gap, double aside = 0.0) {
  const double x = rig.world.X_WR.x + rig.robot.base->front + gap;
  const double y = rig.world.X_WR.y + aside;
  return box(x, y - 0.1, x + 0.2, y + 0.1);
}

NavigatorParameters at_speed(double speed) {
  NavigatorParameters parameters;
  parameters.motion.speed = speed;
  return parameters;
}

class SuddenObstacle : public testing::TestWithParam<double> {};

TEST_P(SuddenObstacle, AMetreAheadIsNeverTouchedAndTheDriveGoesOnWhenItHasLeft) {
  const double speed = GetParam();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Rig rig(seed, at_speed(speed));
    const PlanePose X_WG{8.0, 0.0, 0.0};
    rig.tell(Rig::goal_at(X_WG));
    rig.run(5.0);
    ASSERT_NEAR(rig.world.speed, speed, 0.05);
    rig.world.walls = box_ahead(rig, 1.0, 0.02 * static_cast<double>(seed % 5));
    ASSERT_LT(rig.run_until(DriveState::kBlocked, 10.0), kForever) << seed;
    rig.run(3.0);
    EXPECT_EQ(rig.last.status.state, DriveState::kBlocked) << seed;
    EXPECT_NE(rig.last.status.reason.find("ahead"), std::string::npos) << rig.last.status.reason;
    EXPECT_EQ(rig.world.speed, 0.0) << seed;
    EXPECT_GT(rig.nearest, 0.10) << seed;
    EXPECT_LE(rig.hardest, rig.robot.base->acceleration_max + 1e-6);
    rig.world.walls.clear();
    EXPECT_LT(rig.run_until(DriveState::kDriving, 1.2), kForever) << seed;
    EXPECT_LT(rig.run_until(DriveState::kArrived, 40.0), kForever) << seed;
    EXPECT_LT(rig.distance_to(X_WG), 0.035) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(At, SuddenObstacle, testing::Values(0.4, 0.7, 1.0));

TEST(Obstacle, FasterRobotsBeginToBrakeEarlier) {
  double begin[2] = {};
  for (const int fast : {0, 1}) {
    Rig rig(1, at_speed(fast == 1 ? 1.0 : 0.4));
    rig.world.walls = box(6.0, -0.5, 6.2, 0.5);
    rig.tell(Rig::goal_at({8.0, 0.0, 0.0}));
    const double full = fast == 1 ? 0.95 : 0.38;
    while (rig.world.speed < full) rig.step();
    while (rig.world.speed >= full) rig.step();
    begin[fast] = 6.0 - rig.world.X_WR.x;
    ASSERT_LT(rig.run_until(DriveState::kBlocked, 20.0), kForever);
    rig.run(1.0);
    EXPECT_GT(rig.nearest, 0.12);
    EXPECT_LT(rig.nearest, 0.25);
  }
  EXPECT_GT(begin[1], begin[0] + 0.5);
}

TEST(Obstacle, SomethingThatComesNearAStandingRobotKeepsItThere) {
  Rig rig;
  rig.world.walls = box_ahead(rig, 0.05);
  rig.tell(Rig::goal_at({2.0, 0.0, 0.0}));
  rig.run(3.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kBlocked);
  EXPECT_EQ(rig.fastest, 0.0);
}

TEST(Obstacle, ACorridorWithTenCentimetresOnEachSideIsPassed) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Rig rig(seed);
    rig.world.walls = {{{0.6, 0.28}, {3.0, 0.28}}, {{0.6, -0.28}, {3.0, -0.28}}};
    const PlanePose X_WG{3.8, 0.0, 0.0};
    rig.tell(Rig::goal_at(X_WG, 0.03));
    EXPECT_LT(rig.run_until(DriveState::kArrived, 60.0), kForever) << seed << ": " << rig.last.status.reason;
    EXPECT_FALSE(rig.touched) << seed;
  }
}

TEST(Obstacle, AWallBesideTheWayFartherThanTheClearanceDoesNotStopIt) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Rig rig(seed);
    rig.world.walls = {{{-1.0, 0.48}, {5.0, 0.48}}};  // 30 cm beside the robot
    rig.tell(Rig::goal_at({4.0, 0.0, 0.0}));
    double time = 0.0;
    while (rig.last.status.state != DriveState::kArrived && time < 40.0) {
      rig.step();
      ASSERT_NE(rig.last.status.state, DriveState::kBlocked) << rig.last.status.reason;
      time += 0.02;
    }
    EXPECT_LT(time, 40.0) << seed;
  }
}

TEST(Obstacle, AWallBesideTheWayNearerThanTheClearanceStopsIt) {
  Rig rig;
  rig.world.walls = {{{1.5, 0.26}, {5.0, 0.26}}};  // 8 cm beside the robot, from there on
  rig.tell(Rig::goal_at({4.0, 0.0, 0.0}));
  EXPECT_LT(rig.run_until(DriveState::kBlocked, 40.0), kForever);
  EXPECT_GT(rig.nearest, 0.1);
}

TEST(Obstacle, BehindIsLookedAtWhileReversing) {
  Rig rig;
  rig.world.walls = {{{-0.5, -1.0}, {-0.5, 1.0}}};
  rig.tell(Rig::goal_at({-0.4, 0.0, 0.0}));
  ASSERT_LT(rig.run_until(DriveState::kBlocked, 20.0), kForever);
  EXPECT_NE(rig.last.status.reason.find("behind"), std::string::npos) << rig.last.status.reason;
  EXPECT_GT(rig.nearest, 0.12);
}

TEST(Obstacle, EchoesThatGetLostDoNotMakeItTouch) {
  WorldSettings deaf;
  deaf.lost_echoes = 0.3;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Rig rig(seed, at_speed(0.8), deaf);
    rig.world.walls = {{{4.0, -0.3}, {4.0, 0.3}}};
    rig.tell(Rig::goal_at({6.0, 0.0, 0.0}));
    rig.run(20.0);
    EXPECT_GT(rig.nearest, 0.05) << seed;
  }
}

}  // namespace
}  // namespace markservo::base_navigator::test
