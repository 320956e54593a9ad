// The localiser on the simulated base: how well it knows the pose, with what the reader and the wheels give.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/geometry/plane_pose.hpp"
#include "tests/unit/rfid-localizer/drive.hpp"

namespace markservo::rfid_localizer {
namespace {

using namespace test;

constexpr double kDegree = geometry::radians(1.0);
constexpr int kSeeds = 8;

DriveSettings on_the_course(int seed) {
  DriveSettings settings;
  settings.seed = static_cast<std::uint64_t>(seed);
  return settings;
}

DriveSettings in_the_hall(int seed) {
  DriveSettings settings = on_the_course(seed);
  settings.rig.tag_field = "hall";
  settings.start = {2.0, 0.8, 0.0};
  return settings;
}

TEST(Localizer, KnowsNothingBeforeTheFirstTagAndSaysSo) {
  Drive drive(on_the_course(1));
  drive.stand(0.2);
  const Scored now = drive.now();
  EXPECT_EQ(now.estimate.placement, Placement::kSearching);
  EXPECT_NE(now.estimate.reason, "");
  EXPECT_GT(now.sigma(), 10.0);
}

TEST(Localizer, FindsAStandingRobotAnywhereOnTheFloorWithoutAPrior) {
  double sum = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    DriveSettings settings = in_the_hall(seed);
    settings.start = {0.313 * seed, 3.0 - 0.271 * seed, 0.7 * seed};
    Drive drive(settings);
    drive.stand(5.0);
    const Scored now = drive.now();
    EXPECT_TRUE(now.localised()) << seed << ": " << now.estimate.reason;
    EXPECT_LT(now.error(), 0.02) << seed;
    EXPECT_LT(now.sigma(), 0.01) << seed;
    EXPECT_GT(std::sqrt(now.estimate.pose.covariance(2, 2)), 60.0 * kDegree) << "nothing tells the heading";
    sum += now.error() / kSeeds;
  }
  EXPECT_LT(sum, 0.01);
}

TEST(Localizer, IsSureOfThePlaceWithinASecond) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Drive drive(on_the_course(seed));
    drive.stand(1.0);
    EXPECT_TRUE(drive.now().localised()) << seed << ": " << drive.now().estimate.reason;
  }
}

TEST(Localizer, KnowsTheHeadingAfterHalfAMetre) {
  double sum = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Drive drive(on_the_course(seed));
    drive.stand(1.0);
    drive.go(1.5, 0.4);
    const Scored now = drive.now();
    EXPECT_LT(now.heading_error(), 10.0 * kDegree) << seed;
    EXPECT_LT(std::sqrt(now.estimate.pose.covariance(2, 2)), 5.0 * kDegree) << seed;
    sum += now.heading_error() / kSeeds;
  }
  EXPECT_LT(sum, 3.5 * kDegree);
}

// The bound of the same course, without a prior, is 1.35 cm after its first second.
TEST(Localizer, FollowsAStraightCourseTo2Centimetres) {
  double sum = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Drive drive(on_the_course(seed));
    drive.stand(2.0);
    drive.go(2.95, 0.4);
    const auto after_a_second = drive.since(3.0);
    sum += mean_error(after_a_second) / kSeeds;
    EXPECT_LT(worst_error(after_a_second), 0.08) << seed;
    EXPECT_NEAR(drive.now().truth.pose.y, 1.1, 0.1) << "the course's end";
    for (const Scored& one : after_a_second) ASSERT_TRUE(one.localised()) << one.time << " s: " << one.estimate.reason;
  }
  EXPECT_LT(sum, 0.02);
}

TEST(Localizer, WithTheHeadingGivenIsRightFromTheStart) {
  double given = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    DriveSettings settings = on_the_course(seed);
    settings.localizer.start_heading = HeadingPrior{kUp, 2.0 * kDegree};
    Drive drive(settings);
    drive.stand(2.0);
    EXPECT_LT(drive.now().heading_error(), 4.0 * kDegree);
    drive.go(2.95, 0.4);
    given += mean_error(drive.since(2.0)) / kSeeds;
  }
  EXPECT_LT(given, 0.016) << "1.1 cm is the bound";
}

TEST(Localizer, FollowsBendsStopsAndBackwardWays) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Drive drive(in_the_hall(seed));
    drive.stand(1.0);
    drive.go(3.0, 0.4, 0.3);
    drive.stand(1.0);
    drive.go(2.0, 0.6, 0.45);
    drive.go(2.0, -0.3, -0.225);
    EXPECT_LT(mean_error(drive.since(3.0)), 0.02) << seed;
    EXPECT_LT(worst_error(drive.since(3.0)), 0.06) << seed;
    EXPECT_LT(drive.now().heading_error(), 6.0 * kDegree) << seed;
    EXPECT_NEAR(drive.now().estimate.pose.speed, -0.3, 0.03) << seed;
    EXPECT_LT(longest_untruth(drive.history(), 4.0), 0.2) << seed;
  }
}

TEST(Localizer, WithoutEncodersFollowsTheVelocity) {
  double sum = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    DriveSettings settings = on_the_course(seed);
    settings.encoders = false;
    Drive drive(settings);
    drive.stand(2.0);
    EXPECT_LT(drive.now().error(), 0.03) << seed;
    drive.go(2.95, 0.4);
    const Scored now = drive.now();
    EXPECT_FALSE(now.estimate.odometry_used);
    EXPECT_TRUE(now.localised()) << now.estimate.reason;
    EXPECT_NEAR(now.estimate.pose.speed, 0.4, 0.1) << seed;
    EXPECT_LT(now.heading_error(), 15.0 * kDegree) << seed;
    EXPECT_LT(longest_untruth(drive.history(), 4.0), 0.45) << seed << ": while it sets off";
    sum += mean_error(drive.since(3.5)) / kSeeds;
  }
  EXPECT_LT(sum, 0.035);
}

TEST(Localizer, UsesTheTimesOfTheReadsWhereTheReaderTellsThem) {
  double told = 0.0;
  double untold = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    for (const bool known : {false, true}) {
      DriveSettings settings = in_the_hall(seed);
      settings.rig.reader.delay = 0.35;  // robot.yaml says 0.19
      settings.rig.reader.read_time_known = known;
      Drive drive(settings);
      drive.stand(1.0);
      drive.go(4.0, 0.4, 0.3);
      (known ? told : untold) += mean_error(drive.since(3.0)) / kSeeds;
    }
  }
  EXPECT_LT(told, 0.018);
  EXPECT_GT(untold, 0.03) << "else this test could not fail";
}

struct DelayScore {
  double bias = 0.0;    // s
  double square = 0.0;  // of error over sigma, on average
};

DelayScore learn_delay(double truth) {
  DelayScore score;
  constexpr int kRuns = 16;
  for (int seed = 1; seed <= kRuns; ++seed) {
    DriveSettings settings = in_the_hall(seed);
    settings.start = {0.5, 0.5, 0.6};
    settings.rig.reader.delay = truth;
    settings.localizer.delay = {0.19, 0.04};
    Drive drive(settings);
    drive.stand(1.0);
    for (int i = 0; i < 6; ++i) {
      drive.go(1.0, 0.4);
      drive.stand(1.0);
    }
    const DelayPrior delay = drive.now().estimate.delay;
    EXPECT_LT(delay.sigma, 0.02);
    score.bias += (delay.mean - truth) / kRuns;
    score.square += std::pow((delay.mean - truth) / delay.sigma, 2) / kRuns;
  }
  return score;
}

TEST(Localizer, LearnsTheReadersDelayInStopAndGo) {
  for (const double truth : {0.14, 0.24}) {
    const DelayScore score = learn_delay(truth);
    EXPECT_LT(std::abs(score.bias), 0.012) << truth;
    EXPECT_LT(score.square, 2.5) << truth;
  }
}

TEST(Localizer, KeepsTheDelayItIsSureOf) {
  DriveSettings settings = in_the_hall(1);
  settings.localizer.delay = {0.19, 0.0};
  Drive drive(settings);
  drive.stand(1.0);
  drive.go(3.0, 0.4);
  EXPECT_NEAR(drive.now().estimate.delay.mean, 0.19, 0.003);
}

}  // namespace
}  // namespace markservo::rfid_localizer
