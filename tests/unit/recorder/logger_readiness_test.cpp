#include "services/recorder/logger/logger_readiness.hpp"

#include <gtest/gtest.h>

namespace markservo::recorder {
namespace {

using State = LoggerReadiness::State;

constexpr std::int64_t kStart_us = 5'000'000;
constexpr std::int64_t kMillisecond_us = 1000;
const LoggerSight kNotYet;
const LoggerSight kTwoThreads{true, 2, false};
const LoggerSight kThreeThreads{true, 3, false};

State observe(LoggerReadiness* readiness, const LoggerSight& sight, std::int64_t after_ms) {
  return readiness->observe(sight, kStart_us + after_ms * kMillisecond_us);
}

TEST(LoggerReadiness, IsReachedWhenTheThreadThatReceivesIsThereAndTheTestOfTheBusIsOver) {
  LoggerReadiness readiness(false, kStart_us);
  EXPECT_EQ(observe(&readiness, kNotYet, 0), State::kStarting);
  EXPECT_EQ(observe(&readiness, kTwoThreads, 50), State::kStarting);
  EXPECT_EQ(observe(&readiness, kThreeThreads, 100), State::kTesting);
  EXPECT_EQ(observe(&readiness, kThreeThreads, 299), State::kTesting);
  EXPECT_EQ(observe(&readiness, kThreeThreads, 300), State::kListens);
}

TEST(LoggerReadiness, IsNotReachedWhereTheTestFails) {
  LoggerReadiness readiness(false, kStart_us);
  EXPECT_EQ(observe(&readiness, kThreeThreads, 100), State::kTesting);
  EXPECT_EQ(observe(&readiness, {true, 3, true}, 300), State::kFailed);
}

TEST(LoggerReadiness, FailsAtOnceWhereItEnds) {
  LoggerReadiness starting(false, kStart_us);
  EXPECT_EQ(observe(&starting, {false, std::nullopt, false}, 50), State::kFailed);
  LoggerReadiness testing(false, kStart_us);
  EXPECT_EQ(observe(&testing, kThreeThreads, 50), State::kTesting);
  EXPECT_EQ(observe(&testing, {false, 0, false}, 100), State::kFailed);
}

TEST(LoggerReadiness, ComesWithoutThatThreadOverTcp) {
  LoggerReadiness readiness(true, kStart_us);
  EXPECT_EQ(observe(&readiness, kTwoThreads, 999), State::kStarting);
  EXPECT_EQ(observe(&readiness, kTwoThreads, 1000), State::kTesting);
  EXPECT_EQ(observe(&readiness, kTwoThreads, 1200), State::kListens);
}

TEST(LoggerReadiness, DoesNotWaitForeverForAThreadThatMayNeverCome) {
  LoggerReadiness readiness(false, kStart_us);
  EXPECT_EQ(observe(&readiness, kTwoThreads, 9'999), State::kStarting);
  EXPECT_EQ(observe(&readiness, kTwoThreads, 10'000), State::kTesting);
  EXPECT_EQ(observe(&readiness, kTwoThreads, 10'200), State::kListens);
}

}  // namespace
}  // namespace markservo::recorder
