// Wheels and sonars as the navigator remembers them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "services/base-navigator/obstacles/sonar_memory.hpp"
#include "tests/unit/base-navigator/rig.hpp"

namespace markservo::base_navigator::test {
namespace {

using geometry::wrapped;

constexpr std::int64_t kStart = 1'700'000'000'000'000;
const OdometryParameters kOdometry = [] {
  OdometryParameters parameters;
  parameters.track = 0.32;
  parameters.wheel_speed = 1.7;
  return parameters;
}();

OdometrySample wheels(int step, double left, double right) {
  return {kStart + std::int64_t{20'000} * step, left, right};
}

TEST(OdometryTrack, FollowsAnArc) {
  OdometryTrack track;
  for (int i = 0; i <= 100; ++i) {
    const double turn = 0.5 * M_PI * i / 100.0;  // a quarter of a circle of 0.5 m
    EXPECT_EQ(track.add(kOdometry, wheels(i, 0.34 * turn, 0.66 * turn)), "");
  }
  // The history is 1.5 s long, so compare with its own beginning.
  EXPECT_NEAR(track.newest().x, 0.5, 1e-6);
  EXPECT_NEAR(track.newest().y, 0.5, 1e-6);
  EXPECT_NEAR(track.newest().heading, 0.5 * M_PI, 1e-9);
  EXPECT_NEAR(track.speed(), 0.5 * 0.5 * M_PI / 2.0, 1e-6);
  EXPECT_NEAR(track.turn_rate(), 0.5 * M_PI / 2.0, 1e-6);
}

TEST(OdometryTrack, KnowsWhereItWasBetweenSamples) {
  OdometryTrack track;
  track.add(kOdometry, wheels(0, 0.0, 0.0));
  track.add(kOdometry, wheels(1, 0.02, 0.02));
  EXPECT_NEAR(track.at(kStart + 5'000, 0.1)->x, 0.005, 1e-9);
  EXPECT_FALSE(track.at(kStart + 200'000, 0.1).has_value());
  EXPECT_FALSE(track.at(kStart - 200'000, 0.1).has_value());
}

TEST(OdometryTrack, RefusesTimeThatGoesBackUntilItIsForgotten) {
  OdometryTrack track;
  track.add(kOdometry, wheels(100, 0.0, 0.0));
  track.add(kOdometry, wheels(101, 0.01, 0.01));
  const int epoch = track.epoch();
  for (int i = 0; i < 10; ++i) EXPECT_NE(track.add(kOdometry, wheels(i, 5.0, 5.0)), "");
  EXPECT_EQ(track.epoch(), epoch);
  EXPECT_NEAR(track.newest().x, 0.01, 1e-9);
  track.forget();
  EXPECT_EQ(track.add(kOdometry, wheels(4, 5.0, 5.0)), "");
  EXPECT_EQ(track.epoch(), epoch + 1);
}

TEST(OdometryTrack, AJumpOfACounterIsNoWay) {
  OdometryTrack track;
  track.add(kOdometry, wheels(0, 0.0, 0.0));
  const int epoch = track.epoch();
  const std::string problem = track.add(kOdometry, wheels(1, 8.3, 0.0));
  EXPECT_NE(problem.find("8.300 m"), std::string::npos) << problem;
  EXPECT_EQ(track.epoch(), epoch + 1);
  EXPECT_NEAR(track.newest().x, 0.0, 1e-9);
  EXPECT_EQ(track.speed(), 0.0);
  EXPECT_EQ(track.add(kOdometry, wheels(2, 8.301, 0.001)), "");
}

TEST(OdometryTrack, ALongSilenceBeginsANewTrack) {
  OdometryTrack track;
  track.add(kOdometry, wheels(0, 0.0, 0.0));
  track.add(kOdometry, wheels(100, 1.0, 1.0));
  EXPECT_NEAR(track.newest().x, 0.0, 1e-9);
  EXPECT_EQ(track.epoch(), 2);
}

class SonarsBeforeAWall : public testing::Test {
 protected:
  SonarsBeforeAWall() {
    settings_.sonar_noise = 0.0;
    settings_.lost_echoes = 0.0;
  }

  // m, from the outline to the nearest thing that is believed to be ahead of it.
  double gap_ahead(const SonarMemory& memory) const {
    const auto& base = *robot_.base;
    const Outline outline{base.front, base.rear, base.half_width};
    double least = 10.0;
    for (const SeenPoint& point : memory.points(parameters_, track_, 0.12)) {
      if (point.p_R.x() > 0.0) least = std::min(least, distance_to_outline(outline, point.p_R));
    }
    return least;
  }

  SonarScanSample scan_at(double x, int step) {
    DriveWorld world(robot_, settings_, 1);
    world.walls = walls_;
    world.X_WR = {x, 0.0, 0.0};
    SonarScanSample scan = world.scan();
    scan.utime = kStart + std::int64_t{20'000} * step;
    return scan;
  }

  robot::RobotDescription robot_ = the_robot();
  WorldSettings settings_;
  SonarMemoryParameters parameters_;
  OdometryTrack track_;
  std::vector<Wall> walls_ = {{{1.0, -1.0}, {1.0, 1.0}}};
};

TEST_F(SonarsBeforeAWall, AFlatFaceIsWhereItIs) {
  track_.add(kOdometry, wheels(0, 0.0, 0.0));
  SonarMemory memory;
  ASSERT_TRUE(memory.add(parameters_, scan_at(1.0 - 0.22 - 0.12, 0), track_));
  EXPECT_NEAR(gap_ahead(memory), 0.12, 0.006);
}

TEST_F(SonarsBeforeAWall, AFlatFaceHidesNothingThatTheClearanceDoesNotKeepOff) {
  track_.add(kOdometry, wheels(0, 0.0, 0.0));
  SonarMemory memory;
  ASSERT_TRUE(memory.add(parameters_, scan_at(1.0 - 0.22 - 0.12, 0), track_));
  const auto wide = memory.points(parameters_, track_, 0.12);
  double most = 0.0;
  for (const double clearance : {0.005, 0.02, 0.03}) {
    const auto points = memory.points(parameters_, track_, clearance);
    ASSERT_EQ(points.size(), wide.size());
    const auto arcs = memory.points(parameters_, track_, 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LE((points[i].p_R - arcs[i].p_R).norm(), std::max(0.0, clearance - 0.01) + 1e-9) << clearance;
      most = std::max(most, (wide[i].p_R - arcs[i].p_R).norm());
    }
  }
  EXPECT_GT(most, 0.025);
}

TEST_F(SonarsBeforeAWall, AnEchoThatItsNeighboursDoNotShareMayBeAnywhereOnItsArc) {
  track_.add(kOdometry, wheels(0, 0.0, 0.0));
  walls_ = {{{1.0, -0.02}, {1.0, 0.02}}};  // a pole straight ahead of sonar 0
  SonarMemory memory;
  ASSERT_TRUE(memory.add(parameters_, scan_at(0.0, 0), track_));
  const auto points = memory.points(parameters_, track_, 0.12);
  ASSERT_FALSE(points.empty());
  double leftmost = 0.0;
  for (const auto& point : points) leftmost = std::max(leftmost, point.p_R.y());
  EXPECT_NEAR(leftmost, 0.78 * std::sin(15.0 * kDegree), 0.02);
}

TEST_F(SonarsBeforeAWall, OneLostEchoDoesNotOpenTheWay) {
  SonarMemory memory;
  track_.add(kOdometry, wheels(0, 0.0, 0.0));
  memory.add(parameters_, scan_at(0.0, 0), track_);
  track_.add(kOdometry, wheels(5, 0.1, 0.1));
  SonarScanSample deaf = scan_at(0.1, 5);
  for (auto& reading : deaf.readings) reading.heard = false;
  memory.add(parameters_, deaf, track_);
  // The old echo is there still, nearer by what the robot went.
  EXPECT_NEAR(gap_ahead(memory), 0.78 - 0.1, 0.03);
  for (int i = 0; i < 2; ++i) {
    track_.add(kOdometry, wheels(10 + 5 * i, 0.1, 0.1));
    deaf.utime = track_.newest_utime();
    memory.add(parameters_, deaf, track_);
  }
  EXPECT_TRUE(memory.points(parameters_, track_, 0.12).empty());
}

TEST_F(SonarsBeforeAWall, AnEchoAtTheLeastRangeIsMarkedBlind) {
  track_.add(kOdometry, wheels(0, 0.0, 0.0));
  SonarMemory memory;
  memory.add(parameters_, scan_at(1.0 - 0.22 - 0.05, 0), track_);
  const auto points = memory.points(parameters_, track_, 0.12);
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const auto& p) { return p.blind_range == 0.10; }));
}

TEST_F(SonarsBeforeAWall, ALeastRangeBeyondSightLeavesNoPoints) {
  track_.add(kOdometry, wheels(0, 0.0, 0.0));
  SonarScanSample scan = scan_at(0.0, 0);
  scan.min_range = 9000.0;
  SonarMemory memory;
  memory.add(parameters_, scan, track_);
  EXPECT_TRUE(memory.points(parameters_, track_, 0.12).empty());
}

TEST_F(SonarsBeforeAWall, AnArcHasBoundedlyManyPointsHoweverWideItsBeam) {
  track_.add(kOdometry, wheels(0, 0.0, 0.0));
  SonarScanSample scan = scan_at(0.0, 0);
  scan.beam_width = 1e12;
  scan.readings.resize(1);
  ASSERT_TRUE(scan.readings[0].heard);
  SonarMemory memory;
  memory.add(parameters_, scan, track_);
  EXPECT_LE(memory.points(parameters_, track_, 0.12).size(), 65U);
}

TEST_F(SonarsBeforeAWall, WhatWasSeenBeforeTheWheelsJumpedIsForgotten) {
  SonarMemory memory;
  track_.add(kOdometry, wheels(0, 0.0, 0.0));
  memory.add(parameters_, scan_at(0.0, 0), track_);
  track_.add(kOdometry, wheels(1, 9.0, 9.0));
  EXPECT_TRUE(memory.points(parameters_, track_, 0.12).empty());
  EXPECT_EQ(memory.newest_utime(track_), 0);
}

TEST(FlatFace, IsNotSeenInOneNearEchoAmongFarOnes) {
  SonarScanSample scan;
  scan.beam_width = 30.0 * kDegree;
  for (int i = 0; i < 16; ++i) {
    const double direction = i * 22.5 * kDegree;
    scan.readings.push_back({{0.22 * std::cos(direction), 0.22 * std::sin(direction), wrapped(direction)}, true, 2.0});
  }
  scan.readings[1].range = 0.15;
  const auto faces = flat_faces(FlatFaceParameters(), scan);
  for (const std::size_t i : {15U, 0U, 1U, 2U, 3U}) {
    // A far face may explain far neighbours, never the near echo.
    EXPECT_TRUE(!faces[i] || faces[i]->distance > 1.0) << i;
  }
  EXPECT_FALSE(faces[1].has_value());
}

TEST(FlatFace, PushesAnArcOutByItsGainAtMost) {
  const SonarReading reading{{0.2, 0.0, 0.0}, true, 0.5};
  const FlatFaceParameters parameters;
  EXPECT_NEAR(range_to_face(parameters, reading, {0.0, 0.7}, 0.2), 0.5 / std::cos(0.2), 1e-9);
  EXPECT_NEAR(range_to_face(parameters, reading, {0.0, 0.9}, 0.0), 0.5 + parameters.gain, 1e-9);
  EXPECT_NEAR(range_to_face(parameters, reading, {0.0, 0.6}, 0.0), 0.5, 1e-9);
}

}  // namespace
}  // namespace markservo::base_navigator::test
