#include "services/recorder/recording_end.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace markservo::recorder {
namespace {

constexpr std::int64_t kSecond_us = 1'000'000;
const LoggerEnd kWell;
const LoggerEnd kFailed{LoggerEnd::Who::kLogger, false, 1};

TEST(ReasonToEnd, IsNoneWhileNothingStandsAgainstIt) {
  RecordingPlan plan;
  EXPECT_EQ(reason_to_end(plan, {false, 1000 * kSecond_us, 500}), std::nullopt);
  plan.duration_s = 10;
  EXPECT_EQ(reason_to_end(plan, {false, 10 * kSecond_us - 1, 500}), std::nullopt);
}

TEST(ReasonToEnd, IsTheFirstThatHolds) {
  RecordingPlan plan;
  plan.duration_s = 10;
  EXPECT_EQ(reason_to_end(plan, {true, 10 * kSecond_us, 0}), EndReason::kTold);
  EXPECT_EQ(reason_to_end(plan, {false, 10 * kSecond_us, 0}), EndReason::kTimeIsUp);
  EXPECT_EQ(reason_to_end(plan, {false, 0, 499}), EndReason::kDiskNearlyFull);
}

TEST(ReasonInTheEnd, IsTheLoggersWhereItFailed) {
  EXPECT_EQ(reason_in_the_end(EndReason::kTold, kWell, true), EndReason::kTold);
  EXPECT_EQ(reason_in_the_end(EndReason::kTold, kFailed, false), EndReason::kLoggerFailed);
  EXPECT_EQ(reason_in_the_end(EndReason::kLoggerFailed, kFailed, true), EndReason::kDiskFull);
  EXPECT_EQ(reason_in_the_end(EndReason::kDiskNearlyFull, kFailed, false), EndReason::kDiskNearlyFull);
  EXPECT_EQ(reason_in_the_end(EndReason::kDiskNearlyFull, kFailed, true), EndReason::kDiskFull);
}

TEST(Fault, IsNoneWhereItEndedAsItShould) {
  EXPECT_EQ(fault_of(EndReason::kTold, kWell, {}, 900), std::nullopt);
  EXPECT_EQ(fault_of(EndReason::kTimeIsUp, kWell, {}, 900), std::nullopt);
}

TEST(Fault, IsSaidWithItsNumbers) {
  EXPECT_EQ(fault_of(EndReason::kDiskNearlyFull, kWell, {}, 499),
            "only 499 MB are free on the disk, less than --min-free 500");
  EXPECT_EQ(fault_of(EndReason::kDiskFull, kFailed, {}, 0), "the disk is full");
  EXPECT_EQ(fault_of(EndReason::kLoggerFailed, {LoggerEnd::Who::kLogger, true, SIGABRT}, {}, 900),
            "lcm-logger was killed by signal 6 (SIGABRT)");
}

TEST(EndReasons, AreNamedAsInEveryManifest) {
  EXPECT_EQ(text_of(EndReason::kTold), "told to");
  EXPECT_EQ(text_of(EndReason::kTimeIsUp), "time is up");
  EXPECT_EQ(text_of(EndReason::kDiskNearlyFull), "disk nearly full");
  EXPECT_EQ(text_of(EndReason::kDiskFull), "disk full");
  EXPECT_EQ(text_of(EndReason::kLoggerFailed), "logger failed");
  EXPECT_EQ(text_of(EndReason::kKilled), "killed");
}

}  // namespace
}  // namespace markservo::recorder
