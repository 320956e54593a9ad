#include "tests/experiments/stale_drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/RobotPose.hpp>

#include "tests/unit/bus/memq_bus.hpp"

namespace markservo::experiments {
namespace {

constexpr std::int64_t kPeriod_us = 20'000;

// A base at 0.4 m/s that brakes by 0.8 m/s^2 from `brakes_at` (s) on; its last message is of 1 s.
class Silence : public ::testing::Test {
 protected:
  void run(double brakes_at, double until = 3.0) {
    double y = 0.0;
    double speed = 0.4;
    for (std::int64_t utime = kPeriod_us; utime <= static_cast<std::int64_t>(until * 1e6); utime += kPeriod_us) {
      if (utime <= 1'000'000) watch_.message(utime);
      if (1e-6 * static_cast<double>(utime) > brakes_at) speed = std::max(0.0, speed - 0.8 * 0.02);
      y += 0.02 * speed;
      truth_.utime = utime;
      truth_.pose.y = y;
      truth_.speed = speed;
      watch_.observe(truth_);
    }
  }

  SilenceWatch watch_{SilenceLimits()};
  SimBaseTruth truth_{};
};

TEST_F(Silence, ThatStopsTheBaseInTimeIsFine) {
  run(1.3);
  EXPECT_NEAR(watch_.longest(), 2.0, 0.03);
  EXPECT_EQ(watch_.moved(), 0.0);
  EXPECT_EQ(watch_.turned(), 0.0);
}

TEST_F(Silence, ThatDoesNotStopTheBaseIsTold) {
  run(5.0);
  // 0.3 s until it must brake, 0.5 s of braking, 0.2 s of margin: it has no right to the last second.
  EXPECT_NEAR(watch_.moved(), 0.4, 0.02);
}

TEST_F(Silence, ThatStopsTheBaseHalfASecondLateIsTold) {
  run(1.8);
  EXPECT_GT(watch_.moved(), 0.02);
}

TEST_F(Silence, OfABaseThatOnlyTurnsIsTold) {
  run(1.3);
  for (int i = 0; i < 10; ++i) {
    truth_.utime += kPeriod_us;
    truth_.pose.heading -= 0.01;
    watch_.observe(truth_);
  }
  EXPECT_NEAR(watch_.turned(), 0.1, 1e-9);
}

TEST_F(Silence, EndsWithANewerMessageOnly) {
  run(1.3);
  watch_.message(1'000'000);
  truth_.utime += kPeriod_us;
  truth_.pose.y += 0.01;
  watch_.observe(truth_);
  EXPECT_NEAR(watch_.moved(), 0.01, 1e-9) << "a repeated message is no new one";
  watch_.message(truth_.utime);
  truth_.utime += kPeriod_us;
  truth_.pose.y += 0.01;
  watch_.observe(truth_);
  EXPECT_NEAR(watch_.moved(), 0.01, 1e-9);
}

TEST_F(Silence, IsJudgedByTheSpeedAtItsOwnBegin) {
  run(0.9);  // stood already when it had to brake
  watch_.message(truth_.utime);
  const auto go_on = [this](double seconds, double speed) {
    for (int i = 0; i < std::lround(seconds / 0.02); ++i) {
      truth_.utime += kPeriod_us;
      truth_.speed = speed;
      truth_.pose.y += 0.02 * speed;
      watch_.observe(truth_);
    }
  };
  go_on(0.9, 0.4);  // 1 s is allowed at this speed
  EXPECT_EQ(watch_.moved(), 0.0);
  go_on(0.5, 0.4);
  EXPECT_GT(watch_.moved(), 0.1);
}

TEST_F(Silence, ThatBeganWhileTheBaseStoodProvesNothing) {
  watch_.message(kPeriod_us);
  for (int i = 1; i < 100; ++i) {
    truth_.utime = i * kPeriod_us;
    watch_.observe(truth_);
  }
  EXPECT_EQ(watch_.longest(), 0.0);
}

TEST_F(Silence, EndsWithTheWorld) {
  run(5.0, 1.5);
  ++truth_.session;
  truth_.utime = kPeriod_us;
  truth_.pose.y = 0.0;
  watch_.observe(truth_);
  truth_.utime += 5'000'000;
  truth_.pose.y = 1.0;
  watch_.observe(truth_);
  EXPECT_EQ(watch_.moved(), 0.0);
}

TEST(StaleDriveWatch, HearsEachChannelAlone) {
  bus::Bus bus(bus::memq_parameters("experiment"));
  StaleDriveWatch watch(bus);
  auto truths = bus.advertise(channels::kSimBaseTruth);
  auto poses = bus.advertise(channels::kRobotPose);
  auto commands = bus.advertise(channels::kBaseCommand);
  auto goals = bus.advertise(channels::kBaseGoal);
  SimBaseTruth truth{};
  truth.speed = 0.4;
  for (int i = 1; i <= 200; ++i) {
    truth.utime = i * kPeriod_us;
    truth.pose.x = 0.4 * 1e-6 * static_cast<double>(truth.utime);
    truths.publish(truth);
    RobotPose pose{};
    BaseCommand command{};
    BaseGoal goal{};
    pose.utime = command.utime = goal.utime = truth.utime;
    if (i <= 50) poses.publish(pose);
    commands.publish(command);
    goals.publish(goal);
    settle(bus);
  }
  EXPECT_NEAR(watch.pose().longest(), 3.0, 0.05);
  EXPECT_NEAR(watch.pose().moved(), 0.6, 0.03) << "0.3 s, 1 s of braking and 0.2 s were allowed";
  EXPECT_EQ(watch.command().moved(), 0.0);
  EXPECT_EQ(watch.goal().moved(), 0.0);
  EXPECT_NEAR(report_of(watch)["ROBOT_POSE"]["moved_m"].get<double>(), watch.pose().moved(), 1e-12);
}

}  // namespace
}  // namespace markservo::experiments
