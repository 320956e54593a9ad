#include "services/simulator/base/base_rig.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/robot/configuration_error.hpp"

namespace markservo::simulator {
namespace {

constexpr std::int64_t kEpoch = 1'000'000;

robot::RobotDescription test_robot() {
  return robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
}

BaseRig test_rig(std::uint64_t seed = 1) {
  return {test_robot(), {}, {0.2, 0.0, 1.5707963}, seed, kEpoch};
}

TEST(BaseRig, TellsItsWheelsFiftyTimesASecondFromTheEpochOn) {
  BaseRig rig = test_rig();
  std::vector<std::int64_t> times;
  for (int i = 0; i <= 50; ++i) {
    if (const auto due = rig.take_due(); due.odometry) times.push_back(due.odometry->utime);
    rig.step();
  }
  EXPECT_EQ(times, (std::vector<std::int64_t>{kEpoch, kEpoch + 20'000, kEpoch + 40'000, kEpoch + 60'000,
                                              kEpoch + 80'000, kEpoch + 100'000}));
}

TEST(BaseRig, ABaseWithoutCommandsStopsAfterThreeTenthsOfASecond) {
  BaseRig rig = test_rig();
  rig.command(0.4, 0.0);
  while (rig.utime() < kEpoch + 300'000) rig.step();
  const double speed = rig.truth().speed;
  EXPECT_GT(speed, 0.2);
  while (rig.utime() < kEpoch + 310'000) rig.step();
  EXPECT_LT(rig.truth().speed, speed);
  while (rig.utime() < kEpoch + 900'000) rig.step();
  EXPECT_EQ(rig.truth().speed, 0.0);
}

TEST(BaseRig, RepeatedCommandsKeepItGoing) {
  BaseRig rig = test_rig();
  while (rig.utime() < kEpoch + 2'000'000) {
    if ((rig.utime() - kEpoch) % 250'000 == 0) rig.command(0.4, 0.0);
    rig.step();
  }
  EXPECT_NEAR(rig.truth().speed, 0.4, 0.1);
}

TEST(BaseRig, RoundsArriveWithTheReadersDelay) {
  BaseRig rig = test_rig();
  std::vector<std::int64_t> arrivals;
  while (rig.utime() < kEpoch + 500'000) {
    rig.step();
    for (const TagRound& round : rig.take_due().rounds) {
      EXPECT_EQ(round.utime, rig.utime());
      EXPECT_FALSE(round.hits.empty());
      arrivals.push_back(round.utime - kEpoch);
    }
  }
  EXPECT_EQ(arrivals, (std::vector<std::int64_t>{240'000, 340'000, 440'000}));
}

TEST(BaseRig, TheSameSeedGivesTheSameDrive) {
  const auto run = [](std::uint64_t seed) {
    BaseRig rig = test_rig(seed);
    std::string told;
    while (rig.utime() < kEpoch + 2'000'000) {
      if (rig.utime() % 20'000 == 0) rig.command(0.4, 0.1);
      rig.step();
      const BaseOutputs due = rig.take_due();
      if (due.odometry) told += std::to_string(due.odometry->ticks.left) + " ";
      for (const TagRound& round : due.rounds) {
        for (const TagHit& hit : round.hits) told += hit.uid + std::to_string(hit.rssi) + " ";
      }
    }
    return told + std::to_string(rig.truth().pose.x);
  };
  EXPECT_EQ(run(5), run(5));
  EXPECT_NE(run(5), run(6));
}

TEST(BaseRig, ARobotWithoutAReaderOnlyDrives) {
  robot::RobotDescription robot = test_robot();
  robot.rfid.reset();
  BaseRig rig(robot, {}, {}, 1, kEpoch);
  for (int i = 0; i < 500; ++i) rig.step();
  EXPECT_TRUE(rig.take_due().rounds.empty());
  EXPECT_EQ(rig.floor(), nullptr);
}

TEST(BaseRig, NamesWhatItCannotUse) {
  robot::RobotDescription robot = test_robot();
  BaseRigParameters parameters;
  parameters.tag_field = "no_such";
  EXPECT_THROW(BaseRig(robot, parameters, {}, 1, kEpoch), ConfigurationError);
  robot.base.reset();
  EXPECT_THROW(BaseRig(robot, {}, {}, 1, kEpoch), ConfigurationError);
  EXPECT_THROW(BaseRig(test_robot(), {}, {}, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::simulator
