#include "services/rfid-localizer/trust.hpp"

#include <gtest/gtest.h>

namespace markservo::rfid_localizer {
namespace {

constexpr double kNear = 0.02;   // m
constexpr double kUsual = -0.3;  // standard deviations, of a surprise

Trust placed() {
  Trust trust{TrustParameters{}};
  for (int i = 0; i < 3; ++i) trust.follow(Agreement::kAgrees, kUsual, kNear);
  return trust;
}

TEST(Trust, IsWonByThreeRoundsThatAgree) {
  Trust trust{TrustParameters{}};
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kSearching);
  EXPECT_NE(trust.reason(kNear, 0.0).find("no tag"), std::string::npos);
  trust.follow(Agreement::kAgrees, kUsual, kNear);
  trust.follow_silence(0.9);
  trust.follow(Agreement::kAgrees, kUsual, kNear);
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kSearching);
  EXPECT_NE(trust.reason(kNear, 0.0).find("2 of 3"), std::string::npos) << trust.reason(kNear, 0.0);
  trust.follow(Agreement::kAgrees, kUsual, kNear);
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLocalised);
  EXPECT_EQ(trust.reason(kNear, 0.0), "");
}

TEST(Trust, IsLostAfterFiveContradictionsAndSaysSoOnce) {
  Trust trust = placed();
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(trust.follow(Agreement::kContradicts, kUsual, kNear)) << i;
  EXPECT_TRUE(trust.follow(Agreement::kContradicts, kUsual, kNear));
  trust.lose("the reads contradict the pose");
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLost) << "it was placed before";
  EXPECT_NE(trust.reason(kNear, 0.0).find("contradict"), std::string::npos) << trust.reason(kNear, 0.0);
  EXPECT_FALSE(trust.follow(Agreement::kContradicts, kUsual, kNear)) << "counted anew";
}

TEST(Trust, IsWithheldWhileItIsSuspectedToBeLost) {
  Trust trust = placed();
  for (int i = 0; i < 3; ++i) trust.follow(Agreement::kContradicts, kUsual, kNear);
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLost);
  EXPECT_NE(trust.reason(kNear, 0.0).find("contradict"), std::string::npos) << trust.reason(kNear, 0.0);
  trust.follow(Agreement::kAgrees, kUsual, kNear);
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLocalised) << "a wrong alarm";
}

TEST(Trust, SurvivesContradictionsBetweenRoundsThatAgree) {
  Trust trust = placed();
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(trust.follow(Agreement::kContradicts, kUsual, kNear));
    trust.follow(Agreement::kAgrees, kUsual, kNear);
    trust.follow(Agreement::kAgrees, kUsual, kNear);
  }
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLocalised);
}

TEST(Trust, IsLostByReadsThatSurpriseRoundAfterRound) {
  Trust trust = placed();
  int rounds = 0;
  while (rounds < 100 && !trust.follow(Agreement::kAgrees, 4.0, kNear)) ++rounds;
  EXPECT_LT(rounds, 10);
}

TEST(Trust, IsNotLostByAnOddSurprise) {
  Trust trust = placed();
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(trust.follow(Agreement::kAgrees, i % 10 == 0 ? 9.0 : kUsual, kNear));
    EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLocalised);
  }
}

TEST(Trust, IsNotTouchedByRoundsThatSayNothing) {
  Trust trust = placed();
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(trust.follow_silence(0.5));
  EXPECT_EQ(trust.placement(kNear, 0.0), Placement::kLocalised);
}

TEST(Trust, IsLostTheSoonerTheLessASilenceWasToBeExpected) {
  const auto rounds = [](double probability) {
    Trust trust = placed();
    int count = 1;
    while (!trust.follow_silence(probability) && count < 100) ++count;
    return count;
  };
  EXPECT_EQ(rounds(1e-4), 5);
  EXPECT_EQ(rounds(0.05), 8);
  EXPECT_EQ(rounds(0.0), 5);
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
  for (int i = 0; i < 3; ++i) trust.follow(Agreement::kAgrees, kUsual, 0.5);
  EXPECT_EQ(trust.placement(0.5, 0.0), Placement::kSearching);
  EXPECT_EQ(trust.placement(0.5, 9.0), Placement::kSearching);
}

}  // namespace
}  // namespace markservo::rfid_localizer
