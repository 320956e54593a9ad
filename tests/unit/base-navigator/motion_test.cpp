#include "services/base-navigator/kinematics/motion.hpp"

#include <gtest/gtest.h>

#include "services/base-navigator/kinematics/speed_profile.hpp"
#include "services/base-navigator/obstacles/passage.hpp"

namespace markservo::base_navigator {
namespace {

TEST(SpeedProfile, StopsWithinTheWay) {
  for (const double distance : {0.01, 0.1, 1.0}) {
    const double speed = stopping_speed(distance, 0.8, 0.15);
    EXPECT_NEAR(stopping_distance(speed, 0.8, 0.15), distance, 1e-12);
  }
  EXPECT_EQ(stopping_speed(0.0, 0.8, 0.15), 0.0);
  EXPECT_EQ(stopping_speed(-1.0, 0.8, 0.15), 0.0);
}

TEST(SpeedProfile, RampsUpAndDownAtTheirOwnRatesAndPausesAtZero) {
  EXPECT_DOUBLE_EQ(ramped(0.0, 1.0, 0.4, 0.8, 0.1), 0.04);
  EXPECT_DOUBLE_EQ(ramped(1.0, 0.0, 0.4, 0.8, 0.1), 0.92);
  EXPECT_DOUBLE_EQ(ramped(-0.01, 1.0, 0.4, 0.8, 0.1), 0.0);
  EXPECT_DOUBLE_EQ(ramped(0.5, 0.51, 0.4, 0.8, 0.1), 0.51);
}

TEST(NextCommand, BeginsAtTheMeasuredSpeed) {
  const MotionParameters parameters;
  Motion desired;
  desired.speed = 0.5;
  const Command stuck = next_command(parameters, desired, {0.5, 0.0}, {0.0, 0.0}, 0.02);
  EXPECT_LT(stuck.speed, 0.26);
  const Command rolling = next_command(parameters, desired, {0.0, 0.0}, {0.45, 0.0}, 0.02);
  EXPECT_GT(rolling.speed, 0.2);
}

TEST(NextCommand, TurnsWithTheSpeedItReallyHas) {
  const MotionParameters parameters;
  Motion desired;
  desired.speed = 0.5;
  desired.curvature = 1.0;
  Command command;
  for (int i = 0; i < 10; ++i) command = next_command(parameters, desired, command, command, 0.02);
  EXPECT_NEAR(command.speed, 0.08, 1e-9);
  EXPECT_NEAR(command.turn_rate, 0.08, 1e-9);
}

FreePath with(double length) {
  FreePath free;
  free.length = length;
  free.limited = true;
  free.distance = length + 0.15;
  return free;
}

TEST(Passage, SlowsDownBeforeAnObstacleAndStopsAtIt) {
  const PassageParameters parameters;
  PassageState state;
  Motion desired;
  desired.speed = 0.5;
  const Passage far = pass(parameters, 0.4, with(1.0), 0.15, 0.5, desired, 1'000'000, state);
  EXPECT_EQ(far.motion.speed, 0.5);
  const Passage near = pass(parameters, 0.4, with(0.1), 0.15, 0.5, desired, 1'000'000, state);
  EXPECT_LT(near.motion.speed, 0.25);
  EXPECT_GT(near.motion.speed, 0.0);
  EXPECT_FALSE(near.blocked);
  const Passage at = pass(parameters, 0.4, with(0.0), 0.15, 0.5, desired, 1'000'000, state);
  EXPECT_TRUE(at.blocked);
  EXPECT_EQ(at.motion.speed, 0.0);
  EXPECT_NE(at.reason.find("0.15 m ahead"), std::string::npos) << at.reason;
}

TEST(Passage, GoesOnOnlyAfterTheWayWasFreeForAWhile) {
  const PassageParameters parameters;
  PassageState state;
  Motion desired;
  desired.speed = 0.5;
  std::int64_t utime = 1'000'000;
  const auto blocked_with = [&](double length) {
    utime += 100'000;
    return pass(parameters, 0.4, with(length), 0.15, 0.5, desired, utime, state).blocked;
  };
  EXPECT_TRUE(blocked_with(0.0));
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(blocked_with(1.0));
  EXPECT_TRUE(blocked_with(0.03));  // noise: the time begins anew
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(blocked_with(1.0));
  EXPECT_FALSE(blocked_with(1.0));
}

}  // namespace
}  // namespace markservo::base_navigator
