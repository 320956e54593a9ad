#include "services/simulator/world/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/simulator/test_world.hpp"

namespace markservo::simulator {
namespace {

using motion::CommandVerdict;

constexpr std::int64_t kSession = 99;
constexpr std::int64_t kWriter = 5;  // of the commands

Simulation test_simulation(Timing timing = Timing::kLockstep,
                           const std::vector<std::pair<std::string, double>>& changes = {}) {
  return {test_robot(), test_scene(), test_settings(changes), 1, timing, kSession};
}

// Steps up to the next exposure and exposes it as frame `seq`.
void next_frame(Simulation& simulation, std::int64_t seq) {
  while (!simulation.frame_due()) simulation.step();
  simulation.expose(seq);
}

CommandVerdict answer(Simulation& simulation, std::int64_t seq, const robot::JointVector& q) {
  return simulation.command({{kWriter, seq, simulation.utime()}, kSession}, seq, posture(q, 0.05, 5.0)).verdict;
}

double distance_from_home(Simulation& simulation) {
  return (simulation.world().arm().position - test_robot().arm->home).norm();
}

const robot::JointVector kElsewhere(0.3, 1.8, -2.2);

TEST(Simulation, TimeBeginsAtTheEpochAndFramesFollowTheRate) {
  Simulation simulation = test_simulation();
  EXPECT_EQ(simulation.utime(), kEpoch_us);
  EXPECT_TRUE(simulation.frame_due());
  for (int seq = 1; seq <= 31; ++seq) next_frame(simulation, seq);
  EXPECT_EQ(simulation.utime(), kEpoch_us + 1'000'000);
}

TEST(Simulation, NothingMovesBeforeTheStopIsReset) {
  Simulation simulation = test_simulation();
  next_frame(simulation, 1);
  EXPECT_EQ(answer(simulation, 1, kElsewhere), CommandVerdict::kLatched);
  for (int seq = 2; seq < 10; ++seq) next_frame(simulation, seq);
  EXPECT_EQ(distance_from_home(simulation), 0.0);
}

TEST(Simulation, AResetOfTheStopMovesNothingByItself) {
  Simulation simulation = test_simulation();
  next_frame(simulation, 1);
  release(simulation);
  EXPECT_EQ(answer(simulation, 1, kElsewhere), CommandVerdict::kBeforeReset);
  next_frame(simulation, 2);
  EXPECT_EQ(distance_from_home(simulation), 0.0);
  EXPECT_EQ(answer(simulation, 2, kElsewhere), CommandVerdict::kObeyed);
}

TEST(Simulation, ACommandTakesEffectTheGivenFramesLater) {
  for (const int delay : {0, 1, 3}) {
    Simulation simulation = test_simulation(Timing::kLockstep, {{"servo.delay_frames", delay}});
    release(simulation);
    next_frame(simulation, 1);
    ASSERT_EQ(answer(simulation, 1, kElsewhere), CommandVerdict::kObeyed);
    for (int seq = 2; seq <= 1 + delay; ++seq) {
      next_frame(simulation, seq);
      EXPECT_EQ(distance_from_home(simulation), 0.0) << "delay " << delay << ", exposure " << seq;
      answer(simulation, seq, kElsewhere);
    }
    next_frame(simulation, 2 + delay);
    EXPECT_GT(distance_from_home(simulation), 0.01) << "delay " << delay;
  }
}

TEST(Simulation, InRealTimeACommandTakesEffectTheGivenTimeLater) {
  Simulation simulation = test_simulation(Timing::kRealTime, {{"servo.delay_s", 0.05}});
  release(simulation);
  simulation.expose(1);
  ASSERT_EQ(answer(simulation, 1, kElsewhere), CommandVerdict::kObeyed);
  for (int i = 0; i < 25; ++i) simulation.step();
  EXPECT_EQ(distance_from_home(simulation), 0.0);
  simulation.step();
  EXPECT_GT(distance_from_home(simulation), 0.0);
}

TEST(Simulation, WithoutCommandsTheArmFreezesAfterThreeTenthsOfASecond) {
  Simulation simulation = test_simulation(Timing::kLockstep, {{"servo.delay_frames", 0.0}});
  release(simulation);
  next_frame(simulation, 1);
  ArmCommand slow = posture(test_robot().arm->home + robot::JointVector::Constant(0.1), 0.05, 0.1);
  ASSERT_EQ(simulation.command({{kWriter, 1, simulation.utime()}, kSession}, 1, slow).verdict, CommandVerdict::kObeyed);
  for (int i = 0; i < 165; ++i) simulation.step();
  EXPECT_FALSE(simulation.world().arm().moving);
  const double there = distance_from_home(simulation);
  EXPECT_GT(there, 0.0);
  for (int i = 0; i < 100; ++i) simulation.step();
  EXPECT_EQ(distance_from_home(simulation), there);
}

TEST(Simulation, ACommandThatLeadsTheShaftsTooFarIsNotObeyed) {
  Simulation simulation = test_simulation(Timing::kLockstep, {{"servo.delay_frames", 0.0}});
  release(simulation);
  next_frame(simulation, 1);
  const robot::JointVector far = test_robot().arm->home + robot::JointVector(0.0, 0.0, 0.5);
  const CommandAnswer answer =
      simulation.command({{kWriter, 1, simulation.utime()}, kSession}, 1, posture(far, 0.05, 1.0));
  EXPECT_EQ(answer.verdict, CommandVerdict::kLeads);
  EXPECT_EQ(answer.joint, 2U);
  next_frame(simulation, 2);
  EXPECT_EQ(distance_from_home(simulation), 0.0);
}

TEST(Simulation, ACommandThatJumpsAwayFromTheOneBeforeItIsNotObeyedUntilTheArmStands) {
  Simulation simulation = test_simulation(Timing::kLockstep, {{"servo.delay_frames", 0.0}});
  release(simulation);
  next_frame(simulation, 1);
  const robot::JointVector home = test_robot().arm->home;
  const auto tell = [&](std::int64_t seq, double elbow) {
    const ArmCommand told = posture(home + robot::JointVector(0.0, 0.0, elbow), 0.05, 0.2);
    return simulation.command({{kWriter, seq, simulation.utime()}, kSession}, seq, told);
  };
  ASSERT_EQ(tell(1, 0.0).verdict, CommandVerdict::kObeyed);
  next_frame(simulation, 2);
  EXPECT_EQ(tell(2, 0.15).verdict, CommandVerdict::kJumps);
  EXPECT_EQ(tell(3, 0.15).joint, 2U);
  next_frame(simulation, 3);
  EXPECT_EQ(distance_from_home(simulation), 0.0);
  EXPECT_EQ(tell(4, 0.03).verdict, CommandVerdict::kObeyed);
  for (int seq = 4; seq < 15; ++seq) next_frame(simulation, seq);
  EXPECT_EQ(tell(5, 0.15).verdict, CommandVerdict::kObeyed) << "0.3 s without a command: it stands";
}

TEST(Simulation, AfterAResetACommandMayBeginAnywhereNearTheShaftsAlthoughNothingWasLatched) {
  Simulation simulation = test_simulation(Timing::kRealTime);
  release(simulation);
  simulation.expose(1);
  const auto tell = [&](std::int64_t seq, double elbow) {
    const robot::JointVector q = test_robot().arm->home + robot::JointVector(0.0, 0.0, elbow);
    return simulation.command({{kWriter, seq, simulation.utime()}, kSession}, 1, posture(q, 0.05, 0.2)).verdict;
  };
  simulation.step();
  ASSERT_EQ(tell(1, 0.0), CommandVerdict::kObeyed);
  simulation.step();
  ASSERT_EQ(tell(2, 0.15), CommandVerdict::kJumps);
  release(simulation);
  EXPECT_EQ(tell(3, 0.15), CommandVerdict::kObeyed);
}

TEST(Simulation, TwoWritersOfCommandsLatchUntilOneIsAlone) {
  Simulation simulation = test_simulation();
  release(simulation);
  next_frame(simulation, 1);
  ASSERT_EQ(answer(simulation, 1, kElsewhere), CommandVerdict::kObeyed);
  const std::int64_t utime = simulation.utime();
  const ArmCommand here = posture(test_robot().arm->home, 0.05);
  simulation.command({{kWriter + 1, 1, utime}, kSession}, 1, here);
  next_frame(simulation, 2);
  EXPECT_EQ(answer(simulation, 2, kElsewhere), CommandVerdict::kTwoWriters);
  EXPECT_TRUE(simulation.latch().latched());
  EXPECT_EQ(simulation.latch().reason(), "two write JOINT_COMMAND: sessions 5 and 6");
  release(simulation);
  EXPECT_TRUE(simulation.latch().latched()) << "it spoke within the last second";
  for (int i = 0; i < 550; ++i) simulation.step();
  release(simulation);
  EXPECT_FALSE(simulation.latch().latched());
}

TEST(Simulation, AnOldResetReleasesNothing) {
  Simulation simulation = test_simulation(Timing::kRealTime);
  EXPECT_EQ(simulation.hear_stop({{1, 1, simulation.utime() - 2'280'000'000}, true, "a recording"}),
            motion::StopHeard::kStale);
  EXPECT_TRUE(simulation.latch().latched());
}

TEST(Simulation, AStopFreezesTheArmAtOnce) {
  Simulation simulation = test_simulation(Timing::kRealTime);
  release(simulation);
  simulation.expose(1);
  ASSERT_EQ(answer(simulation, 1, kElsewhere), CommandVerdict::kObeyed);
  for (int i = 0; i < 20; ++i) simulation.step();
  stop(simulation);
  EXPECT_TRUE(simulation.latch().latched());
  const double there = distance_from_home(simulation);
  for (int i = 0; i < 20; ++i) simulation.step();
  EXPECT_EQ(distance_from_home(simulation), there);
}

TEST(Simulation, AResetPutsTheWorldBackAndLatches) {
  Simulation simulation = test_simulation();
  release(simulation);
  next_frame(simulation, 1);
  answer(simulation, 1, kElsewhere);
  for (int seq = 2; seq <= 5; ++seq) next_frame(simulation, seq);
  ASSERT_GT(distance_from_home(simulation), 0.0);
  const std::int64_t before = simulation.utime();
  simulation.reset(7, {{"books.x", 0.0}});
  EXPECT_EQ(distance_from_home(simulation), 0.0);
  EXPECT_TRUE(simulation.latch().latched());
  EXPECT_EQ(simulation.seed(), 7U);
  EXPECT_GT(simulation.utime(), before + 300'000);
  EXPECT_TRUE(simulation.frame_due());
  EXPECT_NEAR(mark_of(simulation.world().truth(), "red_book").p_CM.x(), 0.0, 1e-4);
  simulation.reset(8, {});
  EXPECT_NEAR(mark_of(simulation.world().truth(), "red_book").p_CM.x(), 0.0325, 1e-4) << "from the start's settings";
}

TEST(Simulation, AnImpossibleResetChangesNothing) {
  Simulation simulation = test_simulation();
  release(simulation);
  EXPECT_THROW(simulation.reset(7, {{"books.x", 0.0}, {"no.such", 1.0}}), ConfigurationError);
  EXPECT_EQ(simulation.seed(), 1U);
  EXPECT_FALSE(simulation.latch().latched());
  EXPECT_EQ(simulation.settings().books.x, 0.0325);
}

TEST(Simulation, SetChangesWhatCanChangeInTheRunningWorld) {
  Simulation simulation = test_simulation();
  simulation.set({{"light.gain", 0.5}, {"image.noise_sigma", 1.0}});
  EXPECT_EQ(simulation.effects().gain_red, 0.5);
  EXPECT_EQ(simulation.effects().noise_sigma, 1.0);
  EXPECT_THROW(simulation.set({{"light.gain", 1.0}, {"books.x", 0.0}}), ConfigurationError);
  EXPECT_EQ(simulation.settings().light.gain, 0.5) << "all or nothing";
}

TEST(Simulation, ANewFrameRateCountsFromTheLastExposure) {
  Simulation simulation = test_simulation();
  next_frame(simulation, 1);
  next_frame(simulation, 2);
  const std::int64_t before = simulation.utime();
  simulation.set({{"frames.rate_hz", 10.0}});
  next_frame(simulation, 3);
  EXPECT_EQ(simulation.utime() - before, 100'000);
}

TEST(Simulation, FramesAreDroppedAtTheGivenRateTheSameInEveryRun) {
  const auto drops = [] {
    Simulation simulation = test_simulation(Timing::kLockstep, {{"frames.drop_rate", 0.25}, {"frames.rate_hz", 100.0}});
    std::vector<bool> dropped;
    for (int seq = 1; seq <= 200; ++seq) {
      next_frame(simulation, seq);
      dropped.push_back(simulation.dropped());
    }
    return dropped;
  };
  const std::vector<bool> first = drops();
  EXPECT_NEAR(static_cast<double>(std::count(first.begin(), first.end(), true)), 50.0, 20.0);
  EXPECT_EQ(first, drops());
}

TEST(Simulation, ARepeatedExposureIsTheSameFrame) {
  Simulation simulation = test_simulation();
  simulation.expose(1);
  const std::uint64_t seed = simulation.noise().left;
  simulation.expose(2);
  EXPECT_EQ(simulation.noise().left, seed);
  EXPECT_FALSE(simulation.frame_due());
}

}  // namespace
}  // namespace markservo::simulator
