// The table of device_trust.hpp, walked through.

#include "common/motion/device_trust.hpp"

#include <gtest/gtest.h>

namespace markservo::motion {
namespace {

constexpr std::int64_t kStart = 1'000'000'000;

std::int64_t us(double s) {
  return kStart + static_cast<std::int64_t>(1e6 * s);
}

// An arm, real or not: each channel counts for itself.
struct Arm {
  std::int64_t session;
  std::int64_t reports = 0;
  std::int64_t stop_states = 0;

  ReportHeard report(DeviceTrust& trust, double s) {
    return trust.hear_report("JOINT_STATE", {session, ++reports, us(s)});
  }
  ReportHeard stop_state(DeviceTrust& trust, double s, bool latched) {
    return trust.hear_stop_state({session, ++stop_states, us(s)}, latched);
  }
};

class Trust : public testing::Test {
 protected:
  void trust_the_arm() {
    arm_.stop_state(trust_, 0.0, true);
    arm_.report(trust_, 0.0);
    arm_.stop_state(trust_, 0.2, false);
    arm_.report(trust_, 0.21);
  }

  DeviceTrust trust_{"arm"};
  Arm arm_{11};
  Arm other_{22};
};

TEST_F(Trust, BeforeAnyStopStateWhoReportsFirstIsBelieved) {
  EXPECT_EQ(arm_.report(trust_, 0.0), ReportHeard::kTaken);
  EXPECT_EQ(other_.report(trust_, 0.01), ReportHeard::kForeign);
  EXPECT_FALSE(trust_.trusted());
  EXPECT_EQ(trust_.foreign(), 22);
}

TEST_F(Trust, TheFirstStopStateSaysWhoItIsLatchedOrNot) {
  other_.report(trust_, 0.0);
  EXPECT_EQ(arm_.stop_state(trust_, 0.01, false), ReportHeard::kReplaced);
  EXPECT_TRUE(trust_.trusted());
  EXPECT_EQ(arm_.report(trust_, 0.02), ReportHeard::kTaken);
  EXPECT_EQ(other_.report(trust_, 0.03), ReportHeard::kForeign);
}

TEST_F(Trust, ReportsOfOthersAreDroppedAndCountedAndNoConflict) {
  trust_the_arm();
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(other_.report(trust_, 0.3 + 0.01 * i), ReportHeard::kForeign);
    EXPECT_EQ(arm_.report(trust_, 0.305 + 0.01 * i), ReportHeard::kTaken);
  }
  EXPECT_EQ(trust_.foreign_count(), 100);
  EXPECT_EQ(trust_.foreign(), 22);
  EXPECT_EQ(trust_.conflict(), "");
}

TEST_F(Trust, ARestartedMoverComesUpLatchedAndIsBelieved) {
  trust_the_arm();
  EXPECT_EQ(other_.report(trust_, 1.0), ReportHeard::kForeign);
  EXPECT_EQ(other_.stop_state(trust_, 1.0, true), ReportHeard::kReplaced);
  EXPECT_EQ(other_.report(trust_, 1.01), ReportHeard::kTaken);
  EXPECT_EQ(other_.stop_state(trust_, 1.2, false), ReportHeard::kTaken);
  EXPECT_EQ(trust_.session(), 22);
  EXPECT_EQ(trust_.conflict(), "");
}

TEST_F(Trust, OneThatComesUpReleasedIsAConflict) {
  trust_the_arm();
  EXPECT_EQ(other_.stop_state(trust_, 1.0, false), ReportHeard::kConflict);
  EXPECT_EQ(trust_.session(), 11);
  EXPECT_EQ(trust_.conflict(), "two write STOP_STATE of arm: sessions 11 and 22");
}

TEST_F(Trust, AReplacedOneThatSpeaksAgainIsAConflict) {
  trust_the_arm();
  other_.stop_state(trust_, 1.0, true);
  EXPECT_EQ(arm_.report(trust_, 1.01), ReportHeard::kConflict);
  EXPECT_EQ(trust_.conflict(), "two write JOINT_STATE of arm: sessions 22 and 11");
}

TEST_F(Trust, WhatWasUnderWayWhenItWasReplacedIsNoConflict) {
  trust_the_arm();
  other_.stop_state(trust_, 1.0, true);
  EXPECT_EQ(arm_.report(trust_, 0.25), ReportHeard::kLate);
  EXPECT_EQ(trust_.conflict(), "");
}

TEST_F(Trust, TwoWithOneSessionAreAConflict) {
  trust_the_arm();
  Arm twin{11};
  EXPECT_EQ(twin.report(trust_, 0.5), ReportHeard::kConflict);
}

TEST_F(Trust, LateOnesAreDroppedOnEachChannelForItself) {
  trust_the_arm();
  arm_.report(trust_, 0.3);
  EXPECT_EQ(trust_.hear_report("JOINT_STATE", {11, 2, us(0.21)}), ReportHeard::kLate);
  EXPECT_EQ(trust_.hear_report("SONAR_SCAN", {11, 1, us(0.1)}), ReportHeard::kTaken);
  EXPECT_EQ(trust_.hear_stop_state({11, 1, us(0.0)}, true), ReportHeard::kLate);
}

TEST_F(Trust, AClockSetBackIsABeginning) {
  trust_the_arm();
  EXPECT_EQ(arm_.report(trust_, -3600.0), ReportHeard::kAnew);
  EXPECT_EQ(trust_.newest_utime(), us(-3600.0));
  EXPECT_EQ(arm_.stop_state(trust_, -3599.9, false), ReportHeard::kTaken) << "the other channel steps with it";
}

TEST_F(Trust, WhoSpeaksAloneForASecondIsItAfterAConflict) {
  trust_the_arm();
  other_.stop_state(trust_, 1.0, true);
  for (int i = 0; i < 99; ++i) arm_.report(trust_, 1.01 + 0.01 * i);
  EXPECT_EQ(arm_.stop_state(trust_, 1.99, true), ReportHeard::kConflict);
  EXPECT_FALSE(trust_.alone());
  EXPECT_EQ(arm_.stop_state(trust_, 2.2, true), ReportHeard::kReplaced);
  EXPECT_EQ(arm_.stop_state(trust_, 2.4, false), ReportHeard::kTaken);
  EXPECT_EQ(trust_.session(), 11);
  EXPECT_TRUE(trust_.alone());
}

TEST_F(Trust, WhileTwoSpeakNoneIsAlone) {
  trust_the_arm();
  other_.stop_state(trust_, 1.0, true);
  for (int i = 0; i < 400; ++i) {
    arm_.report(trust_, 1.01 + 0.01 * i);
    other_.report(trust_, 1.015 + 0.01 * i);
    if (i % 20 == 0) {
      EXPECT_EQ(arm_.stop_state(trust_, 1.011 + 0.01 * i, true), ReportHeard::kConflict);
    }
    EXPECT_FALSE(trust_.alone());
  }
}

}  // namespace
}  // namespace markservo::motion
