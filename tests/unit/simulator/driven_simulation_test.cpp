// The running simulation's base: which commands move it, what its devices tell.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "services/simulator/world/simulation.hpp"
#include "tests/unit/simulator/test_world.hpp"

namespace markservo::simulator {
namespace {

using motion::CommandVerdict;

constexpr std::int64_t kSession = 99;
constexpr std::int64_t kWriter = 5;  // of the commands

Simulation test_simulation(const std::vector<std::pair<std::string, double>>& changes = {}) {
  std::vector<std::pair<std::string, double>> all = {
      {"base.start_y", 0.05}, {"sonar.noise", 0.0}, {"sonar.dropout", 0}};
  all.insert(all.end(), changes.begin(), changes.end());
  return {test_robot(), test_scene(), test_settings(all), 1, Timing::kLockstep, kSession};
}

// Steps up to the next odometry and tells it; all that became due meanwhile.
MobileBaseOutputs next_odometry(Simulation& simulation) {
  MobileBaseOutputs all = simulation.take_due();
  while (!all.odometry) {
    simulation.step();
    MobileBaseOutputs due = simulation.take_due();
    for (TagRound& round : due.rounds) all.rounds.push_back(std::move(round));
    if (due.scan) all.scan = std::move(due.scan);
    all.odometry = due.odometry;
  }
  simulation.observe_odometry();
  return all;
}

CommandVerdict go(Simulation& simulation, std::int64_t seq, double speed = 0.4) {
  return simulation.command_base({{kWriter, seq, simulation.utime()}, kSession}, speed, 0.0);
}

void step_for(Simulation& simulation, std::int64_t us) {
  for (const std::int64_t end = simulation.utime() + us; simulation.utime() < end;) simulation.step();
}

double speed_of(const Simulation& simulation) {
  return simulation.base_truth().base.speed;
}

TEST(DrivenSimulation, OdometryAndScansBeginAtTheEpochAndFollowTheirRates) {
  Simulation simulation = test_simulation();
  std::vector<std::int64_t> odometries;
  std::vector<std::int64_t> scans;
  for (int i = 0; i <= 50; ++i) {
    const MobileBaseOutputs due = simulation.take_due();
    if (due.odometry) odometries.push_back(due.odometry->utime - kEpoch_us);
    if (due.scan) scans.push_back(due.scan->utime - kEpoch_us);
    simulation.step();
  }
  EXPECT_EQ(odometries, (std::vector<std::int64_t>{0, 20'000, 40'000, 60'000, 80'000, 100'000}));
  EXPECT_EQ(scans, (std::vector<std::int64_t>{0, 50'000, 100'000}));
}

TEST(DrivenSimulation, NothingDrivesBeforeTheStopIsReset) {
  Simulation simulation = test_simulation();
  next_odometry(simulation);
  EXPECT_EQ(go(simulation, 1), CommandVerdict::kLatched);
  step_for(simulation, 500'000);
  EXPECT_EQ(simulation.base_truth().base.pose.y, 0.05);
}

TEST(DrivenSimulation, AResetOfTheStopDrivesNothingByItself) {
  Simulation simulation = test_simulation();
  next_odometry(simulation);
  release(simulation);
  EXPECT_EQ(go(simulation, 1), CommandVerdict::kBeforeReset);
  next_odometry(simulation);
  EXPECT_EQ(speed_of(simulation), 0.0);
  EXPECT_EQ(go(simulation, 2), CommandVerdict::kObeyed);
  next_odometry(simulation);
  EXPECT_GT(speed_of(simulation), 0.0);
}

TEST(DrivenSimulation, OnlyAnswersToAFreshOdometryOfThisSessionCount) {
  Simulation simulation = test_simulation();
  release(simulation);
  next_odometry(simulation);
  const std::int64_t utime = simulation.utime();
  EXPECT_EQ(simulation.command_base({{kWriter, 1, utime}, kSession + 1}, 0.4, 0.0), CommandVerdict::kOtherMover);
  EXPECT_EQ(simulation.command_base({{kWriter, 2, utime + 30'000}, kSession}, 0.4, 0.0), CommandVerdict::kAhead);
  step_for(simulation, 302'000);
  EXPECT_EQ(simulation.command_base({{kWriter, 1, utime}, kSession}, 0.4, 0.0), CommandVerdict::kStale);
  EXPECT_EQ(speed_of(simulation), 0.0);
}

TEST(DrivenSimulation, WithoutCommandsTheBaseBrakesAfterThreeTenthsOfASecond) {
  Simulation simulation = test_simulation();
  release(simulation);
  next_odometry(simulation);
  ASSERT_EQ(go(simulation, 1), CommandVerdict::kObeyed);
  step_for(simulation, 300'000);
  const double fastest = speed_of(simulation);
  EXPECT_GT(fastest, 0.2);
  step_for(simulation, 20'000);
  EXPECT_LT(speed_of(simulation), fastest);
  step_for(simulation, 400'000);
  EXPECT_EQ(speed_of(simulation), 0.0);
}

TEST(DrivenSimulation, AStopBrakesTheBaseAndLatchesIt) {
  Simulation simulation = test_simulation();
  release(simulation);
  std::int64_t seq = 0;
  for (int i = 0; i < 25; ++i) {
    next_odometry(simulation);
    go(simulation, ++seq);
  }
  const double fastest = speed_of(simulation);
  ASSERT_GT(fastest, 0.35);
  stop(simulation);
  step_for(simulation, 600'000);
  EXPECT_EQ(speed_of(simulation), 0.0);
  next_odometry(simulation);
  EXPECT_EQ(go(simulation, ++seq), CommandVerdict::kLatched);
}

TEST(DrivenSimulation, TheWorldFollowsTheBase) {
  Simulation simulation = test_simulation();
  release(simulation);
  for (std::int64_t seq = 1; seq <= 60; ++seq) {
    next_odometry(simulation);
    go(simulation, seq);
  }
  const geometry::PlanePose pose = simulation.base_truth().base.pose;
  EXPECT_GT(pose.y, 0.3);
  const Eigen::Vector3d p_CM = mark_of(simulation.world().truth(), "red_book").p_CM;
  // The mark in W is 0.35 m ahead of the docked R's origin.
  const Eigen::Vector2d p_WM(0.20, 1.05 + 0.35);
  const double expected = (p_WM - Eigen::Vector2d(pose.x, pose.y)).norm();
  EXPECT_NEAR((p_CM.head<2>() - Eigen::Vector2d(0.0325, -0.10)).norm(), expected, 1e-4);
}

TEST(DrivenSimulation, TheFrontSonarTellsHowFarTheObstacleIs) {
  Simulation simulation = test_simulation();
  next_odometry(simulation);
  simulation.set({{"obstacle.present", 1.0}, {"obstacle.x", 0.2}, {"obstacle.y", 0.9}, {"obstacle.size", 0.4}});
  step_for(simulation, 100'000);
  const auto scan = simulation.take_due().scan;
  ASSERT_TRUE(scan.has_value());
  EXPECT_TRUE(scan->echoes[0].heard);
  EXPECT_NEAR(scan->echoes[0].range, 0.9 - 0.2 - (0.05 + 0.22), 1e-9);
  EXPECT_FALSE(scan->echoes[8].heard) << "nothing behind";
  EXPECT_NEAR(simulation.base_truth().nearest, 0.43, 1e-9);
}

TEST(DrivenSimulation, RunningIntoSomethingIsRememberedUntilTheReset) {
  Simulation simulation = test_simulation();
  simulation.step();
  EXPECT_FALSE(simulation.base_truth().touched);
  simulation.set({{"obstacle.present", 1.0}, {"obstacle.x", 0.2}, {"obstacle.y", 0.3}});
  step_for(simulation, 4'000);
  EXPECT_TRUE(simulation.base_truth().touched);
  EXPECT_EQ(simulation.base_truth().nearest, 0.0);
  simulation.set({{"obstacle.present", 0.0}});
  step_for(simulation, 4'000);
  EXPECT_TRUE(simulation.base_truth().touched);
  simulation.reset(1, {});
  simulation.step();
  EXPECT_FALSE(simulation.base_truth().touched);
}

TEST(DrivenSimulation, AResetPutsTheBaseBackAndLatchesIt) {
  Simulation simulation = test_simulation();
  release(simulation);
  for (std::int64_t seq = 1; seq <= 20; ++seq) {
    next_odometry(simulation);
    go(simulation, seq);
  }
  simulation.reset(2, {{"base.start_x", 0.1}});
  const BaseTruth truth = simulation.base_truth().base;
  EXPECT_EQ(truth.pose.x, 0.1);
  EXPECT_EQ(truth.pose.y, 0.05);
  EXPECT_EQ(truth.speed, 0.0);
  const MobileBaseOutputs due = next_odometry(simulation);
  EXPECT_EQ(due.odometry->utime, simulation.utime()) << "told at once";
  EXPECT_TRUE(due.scan.has_value());
  EXPECT_EQ(go(simulation, 21), CommandVerdict::kLatched);
  release(simulation);
  EXPECT_EQ(go(simulation, 22), CommandVerdict::kBeforeReset);
}

TEST(DrivenSimulation, TheReaderCanFailInTheRunningWorld) {
  Simulation simulation = test_simulation({{"base.start_y", 0.5}});
  step_for(simulation, 500'000);
  for (const TagRound& round : simulation.take_due().rounds) EXPECT_FALSE(round.hits.empty());
  simulation.set({{"rfid.missed", 1.0}});
  step_for(simulation, 400'000);
  simulation.take_due();
  step_for(simulation, 500'000);
  const auto rounds = simulation.take_due().rounds;
  EXPECT_EQ(rounds.size(), 5U);
  for (const TagRound& round : rounds) EXPECT_TRUE(round.hits.empty());
}

TEST(DrivenSimulation, ADelayShorterThanHalfARoundIsRefused) {
  Simulation simulation = test_simulation();
  EXPECT_THROW(simulation.set({{"rfid.delay_s", 0.01}}), ConfigurationError);
  EXPECT_THROW(simulation.reset(1, {{"rfid.delay_s", 0.01}}), ConfigurationError);
  EXPECT_NO_THROW(simulation.set({{"rfid.delay_s", 0.05}}));
}

TEST(DrivenSimulation, ARobotWithoutABaseTellsNothingAndObeysNothing) {
  robot::RobotDescription robot = test_robot();
  robot.base.reset();
  Simulation simulation(robot, test_scene(), test_settings(), 1, Timing::kLockstep, kSession);
  release(simulation);
  simulation.step();
  EXPECT_FALSE(simulation.has_base());
  EXPECT_FALSE(simulation.take_due().odometry.has_value());
  EXPECT_EQ(go(simulation, 1), CommandVerdict::kOtherMover);
}

}  // namespace
}  // namespace markservo::simulator
