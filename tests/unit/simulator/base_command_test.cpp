// The simulator's base as a process on a bus.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/WheelOdometry.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus_url.hpp"
#include "services/simulator/world/simulation.hpp"
#include "tests/unit/simulator/simulator_process.hpp"

namespace markservo::simulator {
namespace {

// One metre before the dock, over the tags. Few frames: they cost most of the time.
const std::vector<std::string> kStart = {"--set", "base.start_y=0.05", "--set", "frames.rate_hz=5", "--encoding",
                                         "jpeg"};

std::vector<std::string> with_start(std::vector<std::string> options) {
  options.insert(options.end(), kStart.begin(), kStart.end());
  return options;
}

std::vector<std::string> lockstep_with(const std::string& awaited, const std::vector<std::string>& options = {}) {
  std::vector<std::string> all = {"--lockstep", "--wait-for", awaited};
  all.insert(all.end(), options.begin(), options.end());
  return with_start(all);
}

double forward(const WheelOdometry&) {
  return 0.4;
}

const SimBaseTruth& newest(const Client& client) {
  return client.base_truths.back();
}

// All channels' names in the order in which they were sent.
class Eavesdropper {
 public:
  // Not `subscribe`: GCC 12 checks the wrong pointer in a call through a member's address, and ubsan cries wolf.
  Eavesdropper() : lcm_(url()) {
    constexpr int kAll = 100'000;  // messages: on a busy machine liblcm would drop what waits beyond its usual 30
    lcm_.subscribeFunction(".*", note, &channels_)->setQueueCapacity(kAll);
  }
  void listen() {
    while (lcm_.handleTimeout(0) > 0) {
    }
  }
  const std::vector<std::string>& channels() const { return channels_; }

 private:
  static std::string url() {
    const char* given = std::getenv("MARKSERVO_LCM_URL");
    return given != nullptr ? given : bus::kDefaultUrl;
  }
  static void note(const lcm::ReceiveBuffer*, const std::string& channel, std::vector<std::string>* channels) {
    channels->push_back(channel);
  }

  lcm::LCM lcm_;
  std::vector<std::string> channels_;
};

TEST(SimulatorBase, DrivesInRealTimeOnceReleasedAndTellsItsWheels) {
  Client client;
  const SimulatorProcess simulator(with_start({}));
  client.driver = forward;
  client.until([&] { return client.odometries.size() >= 25; });
  EXPECT_EQ(newest(client).speed, 0.0) << "it comes up stopped";
  client.request_stop(StopRequest::RESET);
  client.until([&] { return newest(client).pose.y > 0.15; });
  EXPECT_GT(client.odometries.back().left_distance, 0.08);
  for (std::size_t i = 1; i < client.odometries.size(); ++i) {
    EXPECT_EQ(client.odometries[i].utime - client.odometries[i - 1].utime, 20'000);
  }
  for (std::size_t i = 1; i < client.scans.size(); ++i) {
    EXPECT_EQ(client.scans[i].utime - client.scans[i - 1].utime, 50'000);
  }
  for (const SonarScan& scan : client.scans) EXPECT_EQ(scan.num_echoes, 16);
  EXPECT_TRUE(
      std::any_of(client.rounds.begin(), client.rounds.end(), [](const auto& round) { return round.num_hits > 0; }));
}

TEST(SimulatorBase, StopsWithoutCommandsAndAtAStop) {
  Client client;
  const SimulatorProcess simulator(with_start({}));
  client.driver = forward;
  client.until([&] { return !client.odometries.empty(); });
  client.request_stop(StopRequest::RESET);
  client.until([&] { return newest(client).speed > 0.2; });
  client.driver = nullptr;
  const std::int64_t silent_from = newest(client).utime;
  client.until([&] { return newest(client).speed == 0.0; });
  EXPECT_LT(newest(client).utime - silent_from, 1'000'000);

  client.driver = forward;
  client.until([&] { return newest(client).speed > 0.1; });
  client.request_stop(StopRequest::STOP);
  const std::int64_t stopped_at = client.stop_states.back().utime;
  client.until([&] { return newest(client).speed == 0.0; });
  EXPECT_LT(newest(client).utime - stopped_at, 700'000);
}

TEST(SimulatorBase, BothDevicesEchoTheStop) {
  Client client;
  const SimulatorProcess simulator(with_start({}));
  client.until([&] { return !client.stop_states.empty(); });
  client.request_stop(StopRequest::RESET);
  const std::int64_t id = client.stop_states.back().request_id;
  std::map<std::string, bool> latched;
  client.until([&] {
    for (const StopState& state : client.stop_states) {
      if (state.request_id == id) latched[state.device] = state.latched != 0;
    }
    return latched.size() == 2;
  });
  EXPECT_EQ(latched, (std::map<std::string, bool>{{"arm", false}, {"base", false}}));
}

TEST(SimulatorBase, AtOneInstantTheOdometryComesLast) {
  Client client;
  Eavesdropper ears;
  const SimulatorProcess simulator(lockstep_with("BASE_COMMAND"));
  client.driver = forward;
  client.until([&] {
    ears.listen();
    return client.rounds.size() >= 3;
  });
  client.until([&] { return client.odometries.back().utime >= client.rounds.back().utime; });
  ears.listen();
  const std::vector<std::string> order = {"RFID_TAG_HITS", "SONAR_SCAN", "SIM_BASE_TRUTH", "WHEEL_ODOMETRY"};
  std::string of_base;  // a digit each, its place in that order
  for (const std::string& channel : ears.channels()) {
    const auto place = std::find(order.begin(), order.end(), channel);
    if (place != order.end()) of_base += std::to_string(place - order.begin());
  }
  EXPECT_NE(of_base.find("023"), std::string::npos) << "a round's answer and an odometry fell together";
  EXPECT_NE(of_base.find("123"), std::string::npos) << "so did a scan and an odometry";
  for (const char* wrong : {"03", "13", "20", "21", "22"}) {
    EXPECT_EQ(of_base.find(wrong), std::string::npos) << "truth goes right before its odometry: " << of_base;
  }
}

TEST(SimulatorBase, TruthHasTheOdometrysTimeAndNumber) {
  Client client;
  const SimulatorProcess simulator(lockstep_with("BASE_COMMAND"));
  client.driver = forward;
  client.until([&] { return client.odometries.size() >= 20; });
  std::map<std::int64_t, std::int64_t> utime_of;
  for (const WheelOdometry& odometry : client.odometries) utime_of[odometry.seq] = odometry.utime;
  for (const SimBaseTruth& truth : client.base_truths) {
    if (utime_of.count(truth.odometry_seq) == 0) continue;
    EXPECT_EQ(utime_of[truth.odometry_seq], truth.utime);
  }
}

TEST(SimulatorBaseLockstep, StandsStillUntilTheOdometryIsAnswered) {
  Client client;
  const SimulatorProcess simulator(lockstep_with("BASE_COMMAND"));
  client.until([&] { return !client.odometries.empty(); });
  client.for_a_while(std::chrono::milliseconds(1500));
  EXPECT_EQ(client.odometries.back().utime, kEpoch_us) << "nobody answered";
  EXPECT_GT(client.odometries.back().seq, 1) << "but the odometry was sent again";
  client.answer_odometry(client.odometries.back(), 0.0);
  client.until([&] { return client.odometries.back().utime == kEpoch_us + 20'000; });
  const std::int64_t seq = client.odometries.back().seq;
  client.for_a_while(std::chrono::milliseconds(1000));
  EXPECT_EQ(client.odometries.back().seq, seq) << "once answered, an odometry is sent once";
}

TEST(SimulatorBaseLockstep, AMissingAnswerMakesTheRunInvalid) {
  Client client;
  const SimulatorProcess simulator(lockstep_with("BASE_COMMAND", {"--lockstep-timeout", "1"}));
  client.driver = forward;
  client.until([&] { return client.truths.size() >= 2; });
  EXPECT_TRUE(client.truths.back().valid);
  client.driver = nullptr;
  const std::int64_t last = client.odometries.back().seq;
  client.until([&] { return client.odometries.back().seq > last + 1; });
  client.driver = forward;
  client.answer_odometry(client.odometries.back(), 0.0);
  const std::size_t frames = client.truths.size();
  client.until([&] { return client.truths.size() > frames; });
  EXPECT_FALSE(client.truths.back().valid);
}

TEST(SimulatorBaseLockstep, TheSameSeedGivesTheSameDriveBitForBit) {
  Client client;
  const SimulatorProcess simulator(lockstep_with("JOINT_COMMAND,BASE_COMMAND"));
  client.driver = forward;
  const auto home = [&] { client.answer(client.next_frame(), {0.0, 2.0943951, -2.6179939}); };
  home();
  const auto run = [&](std::int64_t seed) {
    const std::int64_t begin = client.control(SimControl::RESET, seed, {}).utime;
    client.request_stop(StopRequest::RESET);
    client.rounds.clear();
    client.scans.clear();
    client.base_truths.clear();
    home();
    while (client.frames.back().utime < begin + 2'000'000) home();
    std::string told;
    for (const auto& round : client.rounds) {
      told += "\n" + std::to_string(round.utime - begin);
      for (const auto& hit : round.hits) told += " " + hit.uid + " " + std::to_string(hit.rssi);
    }
    for (const auto& scan : client.scans) told += " " + std::to_string(scan.echoes[0].range);
    for (const auto& truth : client.base_truths) {
      if (truth.utime <= begin + 2'000'000)
        told += "\n" + std::to_string(truth.utime - begin) + " " + std::to_string(truth.pose.y);
    }
    return told;
  };
  const std::string first = run(3);
  EXPECT_GT(newest(client).pose.y, 0.4) << "it drove";
  EXPECT_EQ(first, run(3));
  EXPECT_NE(first, run(4));
}

}  // namespace
}  // namespace markservo::simulator
