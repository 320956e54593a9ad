// The simulator as a process on a bus.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <markservo/SimControl.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StopRequest.hpp>

#include "services/simulator/world/simulation.hpp"
#include "tests/unit/simulator/simulator_process.hpp"

namespace markservo::simulator {
namespace {

const std::vector<std::string> kLockstep = {"--lockstep", "--wait-for", "JOINT_COMMAND"};
const std::vector<double> kElsewhere = {0.15, 2.0, -2.5};

std::vector<std::string> lockstep_with(const std::vector<std::string>& options) {
  std::vector<std::string> all = kLockstep;
  all.insert(all.end(), options.begin(), options.end());
  return all;
}

TEST(SimulatorCommand, ImpossibleSettingsEndItWithCodeTwo) {
  EXPECT_EQ(SimulatorProcess({"--set", "no.such=1"}).wait(), 2);
  EXPECT_EQ(SimulatorProcess({"--set", "image.noise_sigma=-1"}).wait(), 2);
  EXPECT_EQ(SimulatorProcess({"--set", "arm.start_elbow_deg=30"}).wait(), 2);
  EXPECT_EQ(SimulatorProcess({"--wait-for", "STEREO_FRAME"}).wait(), 2);
  EXPECT_EQ(SimulatorProcess({"--snapshot", "/nowhere/picture.png"}).wait(), 2);
}

TEST(SimulatorCommand, EndsWithCodeZeroWhenTold) {
  Client client;
  SimulatorProcess simulator(kLockstep);
  client.next_frame();
  EXPECT_EQ(simulator.terminate(), 0);
}

TEST(SimulatorLockstep, StandsStillUntilTheFrameIsAnswered) {
  Client client;
  const SimulatorProcess simulator(kLockstep);
  client.next_frame();
  client.for_a_while(std::chrono::milliseconds(1500));
  EXPECT_EQ(client.frames.back().utime, kEpoch_us) << "nobody answered";
  EXPECT_GT(client.frames.back().seq, 1) << "but the frame was sent again";
  client.answer(client.frames.back(), kElsewhere);
  client.until([&] { return client.frames.back().utime > kEpoch_us; });
  EXPECT_EQ(client.frames.back().utime, kEpoch_us + 34'000);
  const std::int64_t seq = client.frames.back().seq;
  client.for_a_while(std::chrono::milliseconds(1500));
  EXPECT_EQ(client.frames.back().seq, seq) << "once answered, frames are sent once";
}

TEST(SimulatorLockstep, TruthAndJointsOfAnExposureComeBeforeItsFrame) {
  Client client;
  const SimulatorProcess simulator(kLockstep);
  for (int i = 0; i < 4; ++i) client.answer(client.next_frame(), kElsewhere);
  const StereoFrame& frame = client.frames.back();
  ASSERT_FALSE(client.truths.empty());
  EXPECT_EQ(client.truths.back().frame_seq, frame.seq);
  EXPECT_EQ(client.truths.back().frame_session, frame.session);
  EXPECT_EQ(client.truths.back().frame_utime, frame.utime);
  EXPECT_EQ(client.joints.back().utime, frame.utime);
}

TEST(SimulatorLockstep, TheArmMovesOnlyAfterTheStopIsReset) {
  Client client;
  const SimulatorProcess simulator(kLockstep);
  for (int i = 0; i < 4; ++i) client.answer(client.next_frame(), kElsewhere);
  EXPECT_TRUE(client.stop_states.back().latched);
  const std::vector<double> home = client.joints.front().position;
  EXPECT_EQ(client.joints.back().position, home);

  client.request_stop(StopRequest::RESET);
  EXPECT_FALSE(client.stop_states.back().latched);
  for (int i = 0; i < 4; ++i) client.answer(client.next_frame(), kElsewhere);
  EXPECT_NE(client.joints.back().position, home);

  client.request_stop(StopRequest::STOP);
  EXPECT_TRUE(client.stop_states.back().latched);
  const std::vector<double> stopped = client.joints.back().position;
  for (int i = 0; i < 4; ++i) client.answer(client.next_frame(), kElsewhere);
  EXPECT_EQ(client.joints.back().position, stopped);
}

TEST(SimulatorLockstep, TheSameSeedGivesTheSameRunBitForBit) {
  Client client;
  const SimulatorProcess simulator(lockstep_with({"--encoding", "raw"}));
  client.answer(client.next_frame(), kElsewhere);
  const auto run = [&](std::int64_t seed) {
    client.control(SimControl::RESET, seed, {{"servo.deadband_deg", 0.3}});
    client.request_stop(StopRequest::RESET);
    client.until([&] { return client.frames.back().seq == client.truths.back().frame_seq; });
    std::vector<StereoFrame> frames;
    for (int i = 0; i < 6; ++i) {
      frames.push_back(client.next_frame());
      client.answer(frames.back(), kElsewhere);
    }
    client.next_frame();
    return std::make_pair(frames, client.truths.back());
  };
  const auto [frames, truth] = run(3);
  const auto [same_frames, same_truth] = run(3);
  const auto [other_frames, other_truth] = run(4);
  ASSERT_EQ(frames.size(), same_frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_TRUE(frames[i].left == same_frames[i].left && frames[i].right == same_frames[i].right) << "frame " << i;
  }
  EXPECT_EQ(truth.shaft, same_truth.shaft);
  EXPECT_NE(frames.back().left, other_frames.back().left);
}

TEST(SimulatorLockstep, AMissingAnswerMakesTheRunInvalidUntilTheNextReset) {
  Client client;
  const SimulatorProcess simulator(lockstep_with({"--lockstep-timeout", "2"}));
  client.answer(client.next_frame(), kElsewhere);
  client.next_frame();
  EXPECT_TRUE(client.truths.back().valid);
  client.answer(client.next_frame(), kElsewhere);
  EXPECT_FALSE(client.truths.back().valid);
  client.next_frame();
  EXPECT_FALSE(client.truths.back().valid) << "an answer does not heal it";
  EXPECT_TRUE(client.control(SimControl::RESET, 1, {}).valid);
}

TEST(SimulatorLockstep, LostFramesLeaveGapsAndAreNotWaitedFor) {
  Client client;
  const SimulatorProcess simulator(lockstep_with({"--set", "frames.drop_rate=0.5"}));
  for (int i = 0; i < 10; ++i) client.answer(client.next_frame(), kElsewhere);
  const std::int64_t lost =
      client.frames.back().seq - client.frames.front().seq + 1 - static_cast<std::int64_t>(client.frames.size());
  EXPECT_GT(lost, 1);
  EXPECT_EQ(client.truths.back().frame_seq, client.frames.back().seq);
  EXPECT_TRUE(client.truths.back().valid);
}

TEST(SimulatorControl, ResetsAreExecutedOnceAndEchoed) {
  Client client;
  const SimulatorProcess simulator(kLockstep);
  client.next_frame();
  const SimTruth echo = client.control(SimControl::RESET, 2, {{"books.x", 0.0}});
  EXPECT_EQ(echo.control_error, "");
  ASSERT_EQ(echo.num_bodies, 3);
  EXPECT_NEAR(echo.bodies[0].p_CB.x, 0.0, 1e-4);
  client.repeat_control(echo.control_id, SimControl::RESET, 2);
  client.for_a_while(std::chrono::milliseconds(300));
  EXPECT_EQ(client.truths.back().utime, echo.utime);
}

TEST(SimulatorControl, MistakesAreEchoedAndChangeNothing) {
  Client client;
  const SimulatorProcess simulator(kLockstep);
  client.next_frame();
  const std::int64_t before = client.truths.back().utime;
  EXPECT_NE(client.control(SimControl::SET, 0, {{"no.such", 1.0}}).control_error.find("'no.such' is unknown"),
            std::string::npos);
  EXPECT_NE(client.control(SimControl::SET, 0, {{"books.x", 0.0}}).control_error.find("with RESET"), std::string::npos);
  EXPECT_NE(client.control(SimControl::RESET, 1, {{"books.y", 99.0}}).control_error.find("books.y"), std::string::npos);
  EXPECT_EQ(client.truths.back().utime, before);
  EXPECT_EQ(client.control(SimControl::SET, 0, {{"calibration.b_scale", 1.01}}).control_error, "");
  client.answer(client.frames.back(), kElsewhere);
  EXPECT_NEAR(client.next_frame().calibration.baseline, 0.065 * 1.01, 1e-12);
}

TEST(SimulatorRealTime, FramesAndJointStatesFollowTheirRates) {
  Client client;
  const SimulatorProcess simulator({"--set", "frames.rate_hz=10"});
  for (int i = 0; i < 5; ++i) client.next_frame();
  for (std::size_t i = 1; i < client.frames.size(); ++i) {
    EXPECT_EQ(client.frames[i].utime - client.frames[i - 1].utime, 100'000);
  }
  EXPECT_GE(client.joints.size(), 40U);
  EXPECT_GE(client.stop_states.size(), 2U);
}

TEST(SimulatorRealTime, GoesOnAfterAReset) {
  Client client;
  const SimulatorProcess simulator({"--set", "frames.rate_hz=10"});
  client.next_frame();
  const std::int64_t echo_utime = client.control(SimControl::RESET, 5, {}).utime;
  client.next_frame();
  client.next_frame();
  EXPECT_GT(client.frames.back().utime, echo_utime);
}

TEST(SimulatorRealTime, AnArmWithoutCommandsFreezes) {
  Client client;
  const SimulatorProcess simulator({"--set", "frames.rate_hz=20"});
  client.next_frame();
  client.request_stop(StopRequest::RESET);
  client.next_frame();
  client.answer(client.next_frame(), kElsewhere, 0.2);
  const std::int64_t answered = client.frames.back().utime;
  client.until([&] { return client.joints.back().moving; });
  client.until([&] { return client.joints.back().utime > answered + 1'000'000; });
  EXPECT_FALSE(client.joints.back().moving);
  EXPECT_GT(std::abs(client.joints.back().position[0] - kElsewhere[0]), 0.05) << "it never arrived";
}

}  // namespace
}  // namespace markservo::simulator
