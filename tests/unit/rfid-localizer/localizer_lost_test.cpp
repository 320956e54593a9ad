// The localiser when the place it believes in is not, or no longer, true: it must say so.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/rfid-localizer/drive.hpp"

namespace markservo::rfid_localizer {
namespace {

using namespace test;

constexpr int kSeeds = 4;

DriveSettings in_the_hall(int seed) {
  DriveSettings settings;
  settings.seed = static_cast<std::uint64_t>(seed);
  settings.rig.tag_field = "hall";
  settings.start = {1.0, 1.0, 0.3};
  return settings;
}

// s from `time` until the first pose that is LOCALISED, or not.
double until(const Drive& drive, double time, bool localised) {
  for (const Scored& one : drive.since(time)) {
    if (one.localised() == localised) return one.time - time;
  }
  return 1e9;
}

TEST(Localizer, CarriedAwaySaysLostWithinASecondAndFindsItselfAgain) {
  for (const double away : {0.2, 0.3, 0.5, 1.0, 2.5}) {
    for (int seed = 1; seed <= kSeeds; ++seed) {
      Drive drive(in_the_hall(seed));
      drive.stand(1.0);
      drive.go(1.5, 0.4);
      drive.stand(0.5);
      const double time = drive.time();
      const auto before = drive.now().truth.pose;
      drive.carry_to({before.x + 0.6 * away, before.y + 0.8 * away, 2.0});
      drive.stand(4.0);
      const auto since = drive.since(time);
      EXPECT_LT(until(drive, time, false), 1.0) << away << " m, seed " << seed;
      const auto lost = std::find_if(since.begin(), since.end(), [](const Scored& one) { return !one.localised(); });
      ASSERT_NE(lost, since.end()) << away << " m, seed " << seed;
      EXPECT_EQ(lost->estimate.placement, Placement::kLost);
      EXPECT_NE(lost->estimate.reason.find("contradict"), std::string::npos) << lost->estimate.reason;
      EXPECT_TRUE(drive.now().localised()) << away << " m, seed " << seed << ": " << drive.now().estimate.reason;
      EXPECT_LT(drive.now().error(), 0.03) << away << " m, seed " << seed;
      // The first round from there arrives 0.24 s later.
      if (away > 0.25) {
        EXPECT_LE(longest_untruth(since, 4.0), 0.5) << away << " m, seed " << seed;
      } else {
        EXPECT_LE(longest_untruth(since, 4.0), 0.9) << away << " m, seed " << seed;
      }
    }
  }
}

TEST(Localizer, OnAFloorWithDeadTagsMissedReadsAndStraysIsNotLostWithoutCause) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    DriveSettings settings = in_the_hall(seed);
    settings.start = {2.0, 0.8, 0.0};
    settings.rig.reader.missed = 0.2;
    settings.rig.reader.duplicates = 0.3;
    settings.rig.reader.unknown_tags = 0.3;
    settings.rig.reader.false_reads = 0.2;
    settings.rig.floor.missing = 0.1;
    settings.rig.floor.survey_error = 0.005;
    Drive drive(settings);
    drive.stand(2.0);
    drive.go(3.0, 0.4, 0.3);
    drive.stand(1.0);
    drive.go(2.0, 0.6, 0.45);
    for (const Scored& one : drive.since(2.0)) {
      ASSERT_TRUE(one.localised()) << "seed " << seed << " at " << one.time << " s: " << one.estimate.reason;
    }
    EXPECT_LT(mean_error(drive.since(3.0)), 0.035) << seed;
  }
}

TEST(Localizer, OverTheFieldsEdgeIsLostWithAReasonAndBackAtItsReturn) {
  DriveSettings settings;
  settings.start = {0.2, 0.2, kUp};  // the course is 1.1 m long
  Drive drive(settings);
  drive.stand(1.0);
  drive.go(10.0, 0.4);
  EXPECT_EQ(drive.now().estimate.placement, Placement::kLost);
  EXPECT_NE(drive.now().estimate.reason.find(" m only"), std::string::npos) << drive.now().estimate.reason;
  EXPECT_LT(drive.now().error(), 4.0 * drive.now().sigma()) << "the covariance holds all the same";
  drive.carry_to({0.2, 0.5, 0.0});
  drive.stand(2.0);
  EXPECT_TRUE(drive.now().localised()) << drive.now().estimate.reason;
  EXPECT_LT(drive.now().error(), 0.03);
}

TEST(Localizer, WhereTagsMustAnswerButNoneDoesIsLost) {
  Drive drive(in_the_hall(1));
  drive.stand(2.0);
  drive.tamper = [](TagRound& round) { round.reads.clear(); };
  drive.stand(1.5);
  EXPECT_EQ(drive.now().estimate.placement, Placement::kLost);
  EXPECT_NE(drive.now().estimate.reason.find("contradict"), std::string::npos) << drive.now().estimate.reason;
  drive.tamper = [](TagRound&) {};
  drive.stand(2.0);
  EXPECT_TRUE(drive.now().localised()) << drive.now().estimate.reason;
  EXPECT_LT(drive.now().error(), 0.03) << "the tags are forgiven";
}

TEST(Localizer, HearingNothingAnyMoreIsLostAnywhereInTheHall) {
  for (const double speed : {0.0, 0.1, 0.4}) {
    for (int seed = 1; seed <= 12; ++seed) {
      DriveSettings settings = in_the_hall(seed);
      settings.start = {0.7 + 0.173 * seed, 2.9 - 0.191 * seed, 0.3};
      Drive drive(settings);
      drive.go(3.0, 0.1);
      if (!drive.now().localised()) continue;
      drive.tamper = [](TagRound& round) { round.reads.clear(); };
      drive.go(3.0, speed);
      EXPECT_EQ(drive.now().estimate.placement, Placement::kLost) << "seed " << seed << ", " << speed << " m/s";
    }
  }
}

TEST(Localizer, TakesAReaderThatBeganAnewAtAnEarlierTime) {
  Drive drive(in_the_hall(1));
  drive.stand(2.0);
  drive.tamper = [](TagRound& round) { round.utime += 3'600'000'000, round.window_end = round.utime; };
  drive.go(0.4, 0.0);
  drive.tamper = [](TagRound&) {};
  int refused = 0;
  for (int i = 0; i < 40; ++i) {
    try {
      drive.stand(0.1);
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }
  EXPECT_LT(refused, 30);
  drive.stand(2.0);
  EXPECT_TRUE(drive.now().localised()) << drive.now().estimate.reason;
}

TEST(Localizer, WithASilentReaderIsLostWithAReasonAfterTwoSeconds) {
  Drive drive(in_the_hall(1));
  drive.stand(2.0);
  drive.set_reader(false);
  const double time = drive.time();
  drive.stand(3.0);
  EXPECT_NEAR(until(drive, time, false), 2.0, 0.25);
  EXPECT_EQ(drive.now().estimate.placement, Placement::kLost);
  EXPECT_NE(drive.now().estimate.reason.find("reader"), std::string::npos) << drive.now().estimate.reason;
}

// By its wheels a robot knows for a while where it went without reads, and how well.
TEST(Localizer, KeepsCountOfTheWayWhileTheReaderIsSilent) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    DriveSettings settings = in_the_hall(seed);
    settings.start = {2.0, 0.8, 0.0};
    settings.rig.base.drift = 0.01;
    Drive drive(settings);
    drive.stand(1.0);
    drive.go(3.0, 0.4, 0.3);
    drive.set_reader(false);
    const double time = drive.time();
    drive.go(16.0, 0.25, 0.1875);  // almost half around
    EXPECT_LT(drive.now().error(), 4.0 * drive.now().sigma()) << seed;
    EXPECT_LT(drive.now().error(), 0.6) << seed << ": 4 m of way";
    drive.set_reader(true);
    drive.stand(3.0);
    EXPECT_TRUE(drive.now().localised()) << drive.now().estimate.reason;
    EXPECT_LT(drive.now().error(), 0.03) << seed;
    EXPECT_LE(longest_untruth(drive.since(time), 4.0), 0.5) << seed;
  }
}

// Without encoders an empty floor leaves the place open, faster and faster: what is said must stay fit to be sent
// (ROBOT_POSE takes variances up to 10^6 m^2), and the first tags must find the robot again.
TEST(Localizer, WithoutEncodersSurvivesTwentyMinutesOffTheFloor) {
  DriveSettings settings;
  settings.start = {0.2, 0.2, kUp};
  settings.encoders = false;
  Drive drive(settings);
  drive.stand(2.0);
  drive.go(5.0, 0.4);
  drive.stand(1200.0);
  for (const Scored& one : drive.history()) {
    ASSERT_LT(one.estimate.pose.covariance.diagonal().maxCoeff(), 1e6) << one.time;
    ASSERT_TRUE(one.estimate.pose.pose.allFinite()) << one.time;
  }
  EXPECT_EQ(drive.now().estimate.placement, Placement::kLost);
  EXPECT_NE(drive.now().estimate.reason.find("without a tag"), std::string::npos) << drive.now().estimate.reason;
  drive.carry_to({0.2, 0.6, 0.0});
  drive.stand(2.0);
  EXPECT_TRUE(drive.now().localised()) << drive.now().estimate.reason;
  EXPECT_LT(drive.now().error(), 0.03);
}

TEST(Localizer, WithoutEncodersFindsItselfAgainAfterAReadersLongSilence) {
  DriveSettings settings = in_the_hall(1);
  settings.encoders = false;
  Drive drive(settings);
  drive.stand(2.0);
  drive.set_reader(false);
  drive.stand(600.0);
  drive.set_reader(true);
  drive.stand(2.0);
  EXPECT_TRUE(drive.now().localised()) << drive.now().estimate.reason;
  EXPECT_LT(drive.now().error(), 0.03);
}

}  // namespace
}  // namespace markservo::rfid_localizer
