// The localiser on inputs that are wrong, repeated, late, or end: counted, and the pose holds.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/unit/rfid-localizer/drive.hpp"

namespace markservo::rfid_localizer {
namespace {

using namespace test;

DriveSettings in_the_hall(int seed = 1) {
  DriveSettings settings;
  settings.seed = static_cast<std::uint64_t>(seed);
  settings.rig.tag_field = "hall";
  settings.start = {2.0, 0.8, 0.0};
  return settings;
}

// What two drives that heard the same reads believe.
void expect_same_pose(const Drive& a, const Drive& b) {
  EXPECT_EQ(a.now().estimate.pose.pose, b.now().estimate.pose.pose);
  EXPECT_EQ(a.now().estimate.pose.covariance, b.now().estimate.pose.covariance);
}

TEST(Localizer, CountsReadsOfTagsThatTheMapDoesNotHaveAndIsNotMoved) {
  Drive clean(in_the_hall());
  Drive drive(in_the_hall());
  drive.tamper = [](TagRound& round) { round.reads.push_back({"FFFF000000000001", {}}); };
  for (Drive* one : {&clean, &drive}) one->go(2.0, 0.4);
  EXPECT_EQ(clean.localizer().faults().unknown_tags, 0);
  EXPECT_GT(drive.localizer().faults().unknown_tags, 10);
  expect_same_pose(clean, drive);
}

TEST(Localizer, CountsReadsOfTagsOutOfReachAndIsNotMoved) {
  Drive clean(in_the_hall());
  Drive drive(in_the_hall());
  for (Drive* one : {&clean, &drive}) one->stand(2.0);
  const std::string far = the_robot().floor_tags->field("hall").tags.back().uid;
  drive.tamper = [&far](TagRound& round) { round.reads.push_back({far, {}}); };
  for (Drive* one : {&clean, &drive}) one->go(2.0, 0.4);
  EXPECT_EQ(drive.localizer().faults().far_tags, 20);
  expect_same_pose(clean, drive);
  EXPECT_TRUE(drive.now().localised());
}

TEST(Localizer, CountsATagReadTwiceInARoundOnce) {
  Drive clean(in_the_hall());
  Drive drive(in_the_hall());
  drive.tamper = [](TagRound& round) {
    const auto reads = round.reads;
    round.reads.insert(round.reads.end(), reads.begin(), reads.end());
  };
  for (Drive* one : {&clean, &drive}) one->go(2.0, 0.4);
  EXPECT_EQ(clean.localizer().faults().repeated_reads, 0);
  EXPECT_GT(drive.localizer().faults().repeated_reads, 50);
  expect_same_pose(clean, drive);
}

TEST(Localizer, RefusesTimesThatRunBackwardsAndIsNotMoved) {
  Drive drive(in_the_hall());
  drive.go(2.0, 0.4);
  const Scored before = drive.now();
  Localizer& localizer = drive.localizer();
  const TagRound late{drive.utime() - 500'000, 5, drive.utime() - 600'000, drive.utime() - 500'000, false, {}};
  EXPECT_THROW(localizer.observe(late), std::invalid_argument);
  EXPECT_THROW(localizer.observe(EncoderReading{drive.utime() - 20'000, 5, 0, 0}), std::invalid_argument);
  EXPECT_THROW(localizer.observe(EncoderReading{drive.utime(), 5, 0, 0}), std::invalid_argument);
  EXPECT_EQ(localizer.faults().late_rounds, 1);
  EXPECT_EQ(localizer.faults().late_odometry, 2);
  EXPECT_EQ(drive.now().estimate.pose.pose, before.estimate.pose.pose);
  EXPECT_EQ(drive.now().estimate.pose.covariance, before.estimate.pose.covariance);
}

TEST(Localizer, BeginsAnewWithADriverWhoseClockIsAnEarlierOne) {
  Drive drive(in_the_hall());
  drive.go(2.0, 0.4);
  drive.localizer().observe(EncoderReading{1'000'000, 77, 0, 0});
  const Estimate estimate = drive.localizer().estimate(1'000'000);
  EXPECT_EQ(estimate.placement, Placement::kLost);
  EXPECT_NE(estimate.reason.find("WHEEL_ODOMETRY"), std::string::npos) << estimate.reason;
}

TEST(Localizer, RefusesAWindowThatCannotBe) {
  Drive drive(in_the_hall());
  drive.stand(2.0);
  const Scored before = drive.now();
  const std::int64_t now = drive.utime();
  for (const auto& [start, end] : {std::pair<std::int64_t, std::int64_t>(0, 0),
                                   {now - 60'000'000, now},
                                   {now - 10'100'000, now - 10'000'000},
                                   {now, now - 100'000},
                                   {now, now + 100'000}}) {
    EXPECT_THROW(drive.localizer().observe(TagRound{now, 5, start, end, true, {}}), std::invalid_argument) << start;
  }
  EXPECT_EQ(drive.localizer().faults().wrong_windows, 5);
  EXPECT_EQ(drive.now().estimate.pose.pose, before.estimate.pose.pose);
}

TEST(Localizer, TakesAReadOutsideItsWindowForOneOfUnknownMoment) {
  DriveSettings settings = in_the_hall();
  settings.rig.reader.read_time_known = true;
  Drive untimed(settings);
  untimed.tamper = [](TagRound& round) {
    for (TagRead& read : round.reads) read.read_utime.reset();
  };
  Drive mistimed(settings);
  mistimed.tamper = [](TagRound& round) {
    for (TagRead& read : round.reads) *read.read_utime -= 5'000'000;
  };
  for (Drive* one : {&untimed, &mistimed}) one->go(3.0, 0.4);
  expect_same_pose(untimed, mistimed);
}

TEST(Localizer, AtAJumpOfTheTicksGrowsItsCovarianceAndKeepsThePose) {
  Drive drive(in_the_hall());
  drive.stand(1.0);
  drive.go(2.0, 0.4);
  drive.stand(1.0);
  const Scored before = drive.now();
  drive.set_encoders(false);
  Localizer& localizer = drive.localizer();
  localizer.observe(EncoderReading{drive.utime() + 20'000, 5, 30'000, -20'000});
  const Estimate after = localizer.estimate(drive.utime() + 20'000);
  EXPECT_EQ(localizer.faults().tick_jumps, 1);
  EXPECT_LT((after.pose.pose - before.estimate.pose.pose).norm(), 1e-6);
  EXPECT_GT(after.pose.covariance(0, 0), before.estimate.pose.covariance(0, 0) + 0.0004) << "2.4 cm at full speed";
}

// The simulated counters are less than 25 cm below their wrap-around when the drive begins.
TEST(Localizer, TakesNoHarmFromCountersThatWrapAround) {
  for (const int bits : {16, 32}) {
    DriveSettings settings = in_the_hall();
    settings.robot.base->counter_bits = bits;
    Drive drive(settings);
    drive.go(5.0, 0.4, 0.3);
    EXPECT_EQ(drive.localizer().faults().tick_jumps, 0);
    EXPECT_LT(worst_error(drive.since(3.0)), 0.06) << bits;
  }
}

TEST(Localizer, GoesOnByInertiaWhenTheEncodersDieAndByWheelsWhenTheyComeBack) {
  for (int seed = 1; seed <= 6; ++seed) {
    Drive drive(in_the_hall(seed));
    drive.stand(1.0);
    drive.go(3.0, 0.4, 0.3);
    const double died = drive.time();
    drive.set_encoders(false);
    drive.go(3.0, 0.4, 0.3);
    EXPECT_FALSE(drive.now().estimate.odometry_used);
    EXPECT_GT(drive.since(died).size(), 15U) << "a pose per round";
    EXPECT_LT(drive.now().error(), 0.10) << seed;
    drive.set_encoders(true);
    const double back = drive.time();
    drive.go(3.0, 0.4, 0.3);
    EXPECT_TRUE(drive.now().estimate.odometry_used);
    EXPECT_TRUE(drive.now().localised()) << drive.now().estimate.reason;
    EXPECT_LT(mean_error(drive.since(back + 2.0)), 0.03) << seed;
    EXPECT_LE(longest_untruth(drive.since(1.0), 4.0), 0.5) << seed;
  }
}

TEST(Localizer, KnowsTheAntennasPlaceAcrossTheEncodersDeathWhereverItIs) {
  for (int seed = 1; seed <= 4; ++seed) {
    DriveSettings settings = in_the_hall(seed);
    settings.robot.rfid->p_RF = {0.15, 0.05};
    Drive drive(settings);
    drive.stand(1.0);
    drive.go(3.0, 0.4, 0.3);
    drive.stand(1.0);
    drive.set_encoders(false);
    while (drive.localizer().has_wheels()) drive.stand(0.05);
    const Scored now = drive.now();
    const double heading = now.estimate.pose.pose[2];
    const geometry::PlanePose believed{now.estimate.pose.pose[0], now.estimate.pose.pose[1], heading};
    const Eigen::Vector2d p_RF = settings.robot.rfid->p_RF;
    EXPECT_LT((believed * p_RF - now.truth.pose * p_RF).norm(), 0.04) << seed;
    EXPECT_LT(now.error(), 4.0 * now.sigma()) << seed;
  }
}

// After a turn by 180 degrees the heading of the start is the wrong one.
TEST(Localizer, DoesNotTakeTheStartsHeadingForThatOfLater) {
  for (int seed = 1; seed <= 4; ++seed) {
    DriveSettings settings = in_the_hall(seed);
    settings.localizer.start_heading = HeadingPrior{0.0, 0.05};
    Drive drive(settings);
    drive.stand(1.0);
    drive.go(7.0, 0.6, 0.45);
    drive.stand(0.5);
    drive.set_encoders(false);
    drive.stand(1.5);
    drive.set_encoders(true);
    drive.stand(1.0);
    const Scored now = drive.now();
    ASSERT_TRUE(now.estimate.odometry_used);
    EXPECT_GT(now.truth.pose.heading, 2.0);
    EXPECT_LT(now.heading_error(), 3.0 * std::sqrt(now.estimate.pose.covariance(2, 2))) << seed;
  }
}

}  // namespace
}  // namespace markservo::rfid_localizer
