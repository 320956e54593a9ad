// Whether the localiser's covariance is true, stays one, and whether the same inputs give the same estimates.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "tests/unit/rfid-localizer/drive.hpp"
#include "tests/unit/rfid-localizer/tag_lattice.hpp"

namespace markservo::rfid_localizer {
namespace {

using namespace test;

DriveSettings in_the_hall(int seed) {
  DriveSettings settings;
  settings.seed = static_cast<std::uint64_t>(seed);
  settings.rig.tag_field = "hall";
  settings.start = {2.0, 0.8, 0.0};
  return settings;
}

void expect_a_covariance(const std::vector<Scored>& scores) {
  for (const Scored& one : scores) {
    const Eigen::Matrix3d& P = one.estimate.pose.covariance;
    ASSERT_TRUE(P.allFinite()) << one.time << " s";
    ASSERT_LT((P - P.transpose()).norm(), 1e-9 * P.norm()) << one.time << " s";
    ASSERT_GT(P.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0) << one.time << " s\n" << P;
  }
}

// Three degrees of freedom: 3 if the covariance is true.
TEST(LocalizerCovariance, IsTrueOnAverageOverManyShortRuns) {
  constexpr int kRuns = 30;
  double at_the_end = 0.0;
  double on_the_way = 0.0;
  for (int seed = 1; seed <= kRuns; ++seed) {
    DriveSettings settings;
    settings.seed = static_cast<std::uint64_t>(seed);
    Drive drive(settings);
    drive.stand(2.0);
    drive.go(2.6, 0.4);
    at_the_end += drive.now().nees() / kRuns;
    const auto moving = drive.since(3.0);
    for (const Scored& one : moving) on_the_way += one.nees() / kRuns / static_cast<double>(moving.size());
  }
  EXPECT_GT(at_the_end, 1.5);
  EXPECT_LT(at_the_end, 4.5);
  EXPECT_GT(on_the_way, 2.0);
  EXPECT_LT(on_the_way, 4.5);
}

// 34 cm apart, with a reader that reaches 20 cm.
TEST(LocalizerCovariance, IsTrueOnAverageAmongSparseTags) {
  constexpr int kRuns = 30;
  double on_the_way = 0.0;
  double error = 0.0;
  for (int seed = 1; seed <= kRuns; ++seed) {
    DriveSettings settings = in_the_hall(seed);
    settings.robot.rfid->reading_radius = 0.2;
    settings.robot.rfid->edge_softness = 0.02;
    settings.robot.floor_tags->fields.push_back(lattice(12, 12, 0.34));
    settings.rig.tag_field = "lattice";
    Drive drive(settings);
    drive.stand(1.0);
    drive.go(4.0, 0.4, 0.3);
    const auto moving = drive.since(2.5);
    for (const Scored& one : moving) on_the_way += one.nees() / kRuns / static_cast<double>(moving.size());
    error += mean_error(moving) / kRuns;
  }
  EXPECT_GT(on_the_way, 1.5);
  EXPECT_LT(on_the_way, 4.5);
  EXPECT_LT(error, 0.045);
}

TEST(LocalizerCovariance, StaysOneOnLongRandomDrives) {
  for (const bool encoders : {true, false}) {
    for (int seed = 1; seed <= 3; ++seed) {
      DriveSettings settings = in_the_hall(seed);
      settings.start = {2.0, 2.0, 0.0};
      settings.encoders = encoders;
      settings.rig.reader.missed = 0.1;
      Drive drive(settings);
      std::mt19937_64 bits(static_cast<std::uint64_t>(seed));
      std::uniform_real_distribution<double> uniform(-1.0, 1.0);
      for (int i = 0; i < 30; ++i) drive.go(1.0, 0.5 * uniform(bits), 2.0 * uniform(bits));
      expect_a_covariance(drive.history());
    }
  }
}

TEST(LocalizerCovariance, StaysOneOverTenMinutesStandingStill) {
  Drive drive(in_the_hall(2));
  drive.stand(600.0);
  expect_a_covariance(drive.history());
  EXPECT_TRUE(drive.now().localised()) << drive.now().estimate.reason;
  EXPECT_LT(drive.now().error(), 0.01);
  for (const Scored& one : drive.since(2.0)) ASSERT_TRUE(one.localised()) << one.time << ": " << one.estimate.reason;
}

TEST(Localizer, GivesTheSameEstimatesForTheSameInputs) {
  const auto run = [](int seed) {
    DriveSettings settings = in_the_hall(seed);
    settings.rig.reader.unknown_tags = 0.2;
    Drive drive(settings);
    drive.go(2.0, 0.4, 0.3);
    drive.set_encoders(false);
    drive.go(1.5, 0.4, 0.3);
    drive.set_encoders(true);
    drive.go(1.0, 0.4, 0.3);
    return drive.history();
  };
  const auto a = run(3);
  const auto b = run(3);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].estimate.pose.pose, b[i].estimate.pose.pose) << a[i].time;
    ASSERT_EQ(a[i].estimate.pose.covariance, b[i].estimate.pose.covariance) << a[i].time;
    ASSERT_EQ(a[i].estimate.delay.mean, b[i].estimate.delay.mean) << a[i].time;
    ASSERT_EQ(a[i].estimate.reason, b[i].estimate.reason) << a[i].time;
  }
  EXPECT_NE(run(4).back().estimate.pose.pose, a.back().estimate.pose.pose);
}

}  // namespace
}  // namespace markservo::rfid_localizer
