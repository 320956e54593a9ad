// The rules of what the base's services say to each other.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/WheelOdometry.hpp>
#include <string>

#include "tests/unit/messages/violation.hpp"

namespace markservo::messages {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class M>
void expect_refused(const M& message, const std::string& field) {
  EXPECT_NE(violation(message).find(field), std::string::npos) << field << ": '" << violation(message) << "'";
}

RfidTagHits round_of_two() {
  RfidTagHits hits{};
  hits.utime = 10'000'000;
  hits.window_start = 9'900'000;
  hits.window_end = 10'000'000;
  hits.num_hits = 2;
  hits.hits.resize(2);
  for (auto& hit : hits.hits) hit.uid = "E004015000001000";
  return hits;
}

TEST(RfidTagHitsRules, AcceptARoundAndAnEmptyOne) {
  EXPECT_EQ(violation(round_of_two()), "");
  RfidTagHits empty = round_of_two();
  empty.num_hits = 0;
  empty.hits.clear();
  EXPECT_EQ(violation(empty), "");
}

TEST(RfidTagHitsRules, RefuseAWindowThatRunsBackwardsLastsTooLongOrEndsLater) {
  auto hits = round_of_two();
  hits.window_start = hits.window_end + 1;
  expect_refused(hits, "window_end - window_start");
  hits = round_of_two();
  hits.utime = hits.window_end = 100'000'000;
  expect_refused(hits, "window_end - window_start");
  hits = round_of_two();
  hits.window_end = hits.utime + 1;
  expect_refused(hits, "window_end");
  hits = round_of_two();
  hits.window_start = -1;
  expect_refused(hits, "window_start");
}

TEST(RfidTagHitsRules, RefuseUidsTimesAndStrengthsThatCannotBe) {
  auto hits = round_of_two();
  hits.hits[1].uid = "";
  expect_refused(hits, "uid");
  hits.hits[1].uid = std::string(65, 'A');
  expect_refused(hits, "uid");
  hits = round_of_two();
  hits.hits[1].read_utime = -5;
  expect_refused(hits, "read_utime");
  hits = round_of_two();
  hits.hits[0].rssi = kNan;
  EXPECT_EQ(violation(hits), "") << "not known, not looked at";
  hits.hits[0].rssi_known = 1;
  expect_refused(hits, "rssi");
}

TEST(WheelOdometryRules, RefuseWaysThatAreNoNumbersOrTooLong) {
  WheelOdometry odometry{};
  EXPECT_EQ(violation(odometry), "");
  odometry.left_distance = kNan;
  expect_refused(odometry, "left_distance");
  odometry.left_distance = 0.0;
  odometry.right_distance = -1e9;
  expect_refused(odometry, "right_distance");
}

SonarScan scan_of_one() {
  SonarScan scan{};
  scan.min_range = 0.1;
  scan.max_range = 5.0;
  scan.beam_width = 0.5;
  scan.num_echoes = 1;
  scan.echoes.resize(1);
  scan.echoes[0].range = 1.0;
  return scan;
}

TEST(SonarScanRules, RefuseRangesAndPosesThatCannotBe) {
  EXPECT_EQ(violation(scan_of_one()), "");
  auto scan = scan_of_one();
  scan.max_range = 0.1;
  expect_refused(scan, "max_range");
  for (const double range : {-0.1, 5.1, kNan}) {
    scan = scan_of_one();
    scan.echoes[0].range = range;
    expect_refused(scan, "range");
  }
  scan = scan_of_one();
  scan.echoes[0].pose.x = kNan;
  expect_refused(scan, "pose");
  scan = scan_of_one();
  scan.beam_width = -0.1;
  expect_refused(scan, "beam_width");
}

TEST(RobotPoseRules, RefuseWhatNobodyMayDriveBy) {
  RobotPose pose{};
  EXPECT_EQ(violation(pose), "");
  pose.state = 3;
  expect_refused(pose, "state");
  pose = {};
  pose.pose.heading = kNan;
  expect_refused(pose, "pose");
  pose = {};
  pose.pose.x = 2e4;
  expect_refused(pose, "pose");
  pose = {};
  pose.covariance.hh = -1e-9;
  expect_refused(pose, "covariance");
  pose = {};
  pose.covariance.xx = 2e6;
  expect_refused(pose, "covariance");
  pose = {};
  pose.covariance.xy = kNan;
  expect_refused(pose, "covariance");
  pose = {};
  pose.speed = 1e5;
  expect_refused(pose, "speed");
  pose = {};
  pose.paper.compensated_x = kNan;
  expect_refused(pose, "paper");
}

TEST(BaseGoalRules, RefuseGoalsThatAreNone) {
  BaseGoal goal{};
  EXPECT_EQ(violation(goal), "");
  goal.kind = 2;
  expect_refused(goal, "kind");
  goal = {};
  goal.frame = -1;
  expect_refused(goal, "frame");
  goal = {};
  goal.pose.y = kNan;
  expect_refused(goal, "pose");
  goal = {};
  goal.clearance = -0.1;
  expect_refused(goal, "clearance");
  goal = {};
  goal.speed = -0.1;
  expect_refused(goal, "speed");
}

TEST(BaseCommandRules, RefuseSpeedsThatNoBaseMustTry) {
  BaseCommand command{};
  EXPECT_EQ(violation(command), "");
  command.speed = kNan;
  expect_refused(command, "speed");
  command = {};
  command.turn_rate = -1e9;
  expect_refused(command, "turn_rate");
}

TEST(BaseStatusRules, RefuseUnknownStatesAndErrorsThatAreNoNumbers) {
  BaseStatus status{};
  EXPECT_EQ(violation(status), "");
  status.state = 7;
  expect_refused(status, "state");
  status = {};
  status.distance = kNan;
  expect_refused(status, "distance");
}

}  // namespace
}  // namespace markservo::messages
