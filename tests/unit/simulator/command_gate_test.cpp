#include "services/simulator/command_gate.hpp"

#include <gtest/gtest.h>

namespace markservo::simulator {
namespace {

constexpr std::int64_t kSession = 77;
constexpr std::int64_t kNow_us = 10'000'000;

FrameIdentity frame(std::int64_t seq, std::int64_t utime = kNow_us) {
  return {kSession, seq, utime};
}

CommandGate released_after(std::int64_t seq) {
  CommandGate gate(kSession);
  gate.unlatch(seq);
  return gate;
}

TEST(CommandGate, StartsLatched) {
  CommandGate gate(kSession);
  EXPECT_TRUE(gate.latched());
  EXPECT_EQ(gate.offer(frame(1), 1, kNow_us), CommandVerdict::kLatched);
}

TEST(CommandGate, ObeysOnlyFramesExposedAfterTheReset) {
  CommandGate gate = released_after(5);
  EXPECT_EQ(gate.offer(frame(5), 6, kNow_us), CommandVerdict::kBeforeReset);
  EXPECT_EQ(gate.offer(frame(6), 6, kNow_us), CommandVerdict::kObeyed);
}

TEST(CommandGate, ObeysOneCommandPerFrameInOrder) {
  CommandGate gate = released_after(0);
  EXPECT_EQ(gate.offer(frame(3), 3, kNow_us), CommandVerdict::kObeyed);
  EXPECT_EQ(gate.offer(frame(3), 3, kNow_us), CommandVerdict::kOutOfOrder);
  EXPECT_EQ(gate.offer(frame(2), 3, kNow_us), CommandVerdict::kOutOfOrder);
}

TEST(CommandGate, RefusesOtherSessions) {
  CommandGate gate = released_after(0);
  EXPECT_EQ(gate.offer({kSession + 1, 1, kNow_us}, 1, kNow_us), CommandVerdict::kOtherSession);
}

TEST(CommandGate, RefusesFramesThatWereNotExposedYet) {
  CommandGate gate = released_after(0);
  EXPECT_EQ(gate.offer(frame(2), 1, kNow_us), CommandVerdict::kUnknownFrame);
  EXPECT_EQ(gate.offer(frame(1, kNow_us + 1), 1, kNow_us), CommandVerdict::kUnknownFrame);
}

TEST(CommandGate, RefusesFramesOlderThanThreeTenthsOfASecond) {
  CommandGate gate = released_after(0);
  EXPECT_EQ(gate.offer(frame(1), 2, kNow_us + 300'001), CommandVerdict::kStale);
  EXPECT_EQ(gate.offer(frame(1), 2, kNow_us + 300'000), CommandVerdict::kObeyed);
}

TEST(CommandGate, IsSilentThreeTenthsOfASecondAfterTheLastObeyedCommand) {
  CommandGate gate = released_after(0);
  EXPECT_TRUE(gate.silent(kNow_us)) << "there was none yet";
  ASSERT_EQ(gate.offer(frame(1), 1, kNow_us), CommandVerdict::kObeyed);
  EXPECT_FALSE(gate.silent(kNow_us + 300'000));
  EXPECT_TRUE(gate.silent(kNow_us + 300'001));
}

TEST(CommandGate, AStopAndItsResetForgetTheCommandsBefore) {
  CommandGate gate = released_after(0);
  ASSERT_EQ(gate.offer(frame(1), 1, kNow_us), CommandVerdict::kObeyed);
  gate.latch();
  EXPECT_EQ(gate.offer(frame(2), 2, kNow_us), CommandVerdict::kLatched);
  gate.unlatch(2);
  EXPECT_TRUE(gate.silent(kNow_us));
  EXPECT_EQ(gate.offer(frame(2), 2, kNow_us), CommandVerdict::kBeforeReset);
}

TEST(CommandGate, ANewWorldIsLatched) {
  CommandGate gate = released_after(0);
  gate.restart(4);
  EXPECT_TRUE(gate.latched());
  EXPECT_EQ(gate.offer(frame(5), 5, kNow_us), CommandVerdict::kLatched);
}

}  // namespace
}  // namespace markservo::simulator
