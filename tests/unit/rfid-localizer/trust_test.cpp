#include "services/rfid-localizer/trust.hpp"

#include <gtest/gtest.h>

namespace markservo::rfid_localizer {
namespace {

constexpr double kNear = 0.02;  // m

Trust placed() {
  Trust trust{TrustParameters{}};
  for (int i = 0; i < 3; ++i) trust.follow(Agreement::kAgrees, kNear);
  return trust;
}

TEST(Trust, IsWonByThreeRoundsThatAgree) {
  Trust trust{TrustParameters{}};
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kSearching);
  EXPECT_NE(trust.reason(kNear, 0.0).find("no tag"), std::string::npos);
  trust.follow(Agreement::kAgrees, kNear);
  trust.follow(Agreement::kNothing, kNear);
  trust.follow(Agreement::kAgrees, kNear);
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kSearching);
  EXPECT_NE(trust.reason(kNear, 0.0).find("2 of 3"), std::string::npos) << trust.reason(kNear, 0.0);
  trust.follow(Agreement::kAgrees, kNear);
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLocalised);
  EXPECT_EQ(trust.reason(kNear, 0.0), "");
}

TEST(Trust, IsLostAfterFiveContradictionsAndSaysSoOnce) {
  Trust trust = placed();
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(trust.follow(Agreement::kContradicts, kNear)) << i;
  EXPECT_TRUE(trust.follow(Agreement::kContradicts, kNear));
  trust.begin();
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLost) << "it was placed before";
  EXPECT_NE(trust.reason(kNear, 0.0), "");
  EXPECT_FALSE(trust.follow(Agreement::kContradicts, kNear)) << "counted anew";
}

TEST(Trust, SurvivesContradictionsBetweenRoundsThatAgree) {
  Trust trust = placed();
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(trust.follow(Agreement::kContradicts, kNear));
    EXPECT_FALSE(trust.follow(Agreement::kContradicts, kNear));
    trust.follow(Agreement::kAgrees, kNear);
  }
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLocalised);
}

TEST(Trust, IsNotTouchedByRoundsThatSayNothing) {
  Trust trust = placed();
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(trust.follow(Agreement::kNothing, kNear));
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLocalised);
}

TEST(Trust, EndsWhereThePositionIsKnownTooBadly) {
  const Trust trust = placed();
  EXPECT_EQ(trust.placement(0.14, 0.0), Placement::kLocalised);
  EXPECT_EQ(trust.placement(0.16, 0.0), Placement::kLost);
  EXPECT_NE(trust.reason(0.16, 0.0).find("0.16 m"), std::string::npos) << trust.reason(0.16, 0.0);
}

TEST(Trust, EndsWhenTheReaderFallsSilent) {
  const Trust trust = placed();
  EXPECT_EQ(trust.placement(kNear, 1.9), Placement::kLocalised);
  EXPECT_EQ(trust.placement(kNear, 2.1), Placement::kLost);
  EXPECT_NE(trust.reason(kNear, 2.1).find("2.1 s"), std::string::npos) << trust.reason(kNear, 2.1);
}

TEST(Trust, ARobotThatWasNeverPlacedIsSearchingNotLost) {
  Trust trust{TrustParameters{}};
  for (int i = 0; i < 3; ++i) trust.follow(Agreement::kAgrees, 0.5);
  EXPECT_EQ(trust.placement(0.5, 0.0), Placement::kSearching);
  EXPECT_EQ(trust.placement(0.5, 9.0), Placement::kSearching);
}

}  // namespace
}  // namespace markservo::rfid_localizer
