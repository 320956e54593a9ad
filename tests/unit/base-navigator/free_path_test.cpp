#include "services/base-navigator/obstacles/free_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "services/base-navigator/kinematics/course.hpp"

namespace markservo::base_navigator {
namespace {

using geometry::PlanePose;

const Outline kOutline{0.22, 0.18, 0.18};
const std::vector<PathPose> kAhead = straight_path(Direction::kForward, 0.03, 1.5);
const std::vector<PathPose> kBack = straight_path(Direction::kBackward, 0.03, 1.5);

SeenPoint at(double x, double y) {
  SeenPoint point;
  point.p_R = {x, y};
  return point;
}

TEST(FreePath, StopsItsDistanceBeforeWhatStandsInTheWay) {
  const FreePath free = free_path(kOutline, 0.15, {at(1.0, 0.0)}, kAhead);
  EXPECT_TRUE(free.limited);
  EXPECT_NEAR(free.length, 1.0 - 0.22 - 0.15, 1e-6);
  EXPECT_NEAR(free.distance, 0.78, 1e-9);
  EXPECT_EQ(side_of(free.bearing), "ahead");
}

TEST(FreePath, OnlyTheDirectionOfMotionCounts) {
  EXPECT_FALSE(free_path(kOutline, 0.15, {at(1.0, 0.0)}, kBack).limited);
  EXPECT_NEAR(free_path(kOutline, 0.15, {at(-1.0, 0.0)}, kBack).length, 1.0 - 0.18 - 0.15, 1e-6);
}

TEST(FreePath, WhatIsBesideTheCorridorCountsWhenNearerThanTheClearance) {
  EXPECT_FALSE(free_path(kOutline, 0.09, {at(1.0, 0.28)}, kAhead).limited);
  EXPECT_TRUE(free_path(kOutline, 0.11, {at(1.0, 0.28)}, kAhead).limited);
  EXPECT_TRUE(free_path(kOutline, 0.01, {at(1.0, 0.17)}, kAhead).limited);
}

TEST(FreePath, WhatIsTooNearAlreadyForbidsOnlyComingCloser) {
  const SeenPoint shelf = at(0.30, 0.0);  // 8 cm before the front
  EXPECT_EQ(free_path(kOutline, 0.15, {shelf}, kAhead).length, 0.0);
  EXPECT_FALSE(free_path(kOutline, 0.15, {shelf}, kBack).limited);
  const SeenPoint beside = at(0.0, 0.25);
  EXPECT_FALSE(free_path(kOutline, 0.15, {beside}, kAhead).limited);
}

// m, the nearest that the point comes to the outline on the part of the path that is free.
double nearest_on(const FreePath& free, const std::vector<PathPose>& path, const SeenPoint& point) {
  double least = distance_to_outline(kOutline, point.p_R);
  for (const PathPose& pose : path) {
    if (pose.length <= free.length) {
      least = std::min(least, distance_to_outline(kOutline, pose.X_RS.inverse() * point.p_R));
    }
  }
  return least;
}

TEST(FreePath, ATurnEndsBeforeItSweepsThroughWhatIsTooNearAlready) {
  const auto turn = turning_path(kOutline, M_PI / 2.0, 0.03);
  // 4 cm before the front: of the first one the turn even leads away at first.
  for (const SeenPoint& pole : {at(0.26, 0.10), at(0.26, 0.0)}) {
    const FreePath free = free_path(kOutline, 0.05, {pole}, turn);
    EXPECT_TRUE(free.limited) << pole.p_R.y();
    EXPECT_GE(free.length, 0.06) << pole.p_R.y();
    EXPECT_GE(nearest_on(free, turn, pole), 0.03) << pole.p_R.y();
  }
}

TEST(FreePath, ACurvedWayEndsBeforeItsSideSwingsThroughWhatIsTooNearAlready) {
  const SeenPoint post = at(0.05, 0.21);  // 3 cm beside the robot
  std::vector<PathPose> path = {{PlanePose(), 0.0}};
  for (int i = 1; i <= 10; ++i) {
    path.push_back({path.back().X_RS * PlanePose{0.03, 0.0, 0.12}, 0.03 * i});  // 4 rad per m, to the left
  }
  const FreePath free = free_path(kOutline, 0.05, {post}, path);
  EXPECT_TRUE(free.limited);
  EXPECT_GE(nearest_on(free, path, post), 0.02);
}

TEST(FreePath, NoiseOfACentimetreIsNoApproachToWhatIsTooNearAlready) {
  std::vector<PathPose> path = {{PlanePose(), 0.0}};
  for (int i = 1; i <= 10; ++i) path.push_back({{0.03 * i, 0.0005 * i, 0.001 * i}, 0.03 * i});
  EXPECT_FALSE(free_path(kOutline, 0.05, {at(0.0, 0.22)}, path).limited);
}

TEST(FreePath, AnEchoTooNearToBeMeasuredKeepsTheWholeBlindRange) {
  SeenPoint blind = at(0.32, 0.0);
  blind.blind_range = 0.10;
  EXPECT_LT(free_path(kOutline, 0.03, {blind}, kAhead).length, 1e-6);
  EXPECT_NEAR(free_path(kOutline, 0.03, {at(0.32, 0.0)}, kAhead).length, 0.07, 1e-6);
}

TEST(FreePath, ACurvedWaySweepsItsOwnCorridor) {
  // A goal 1 m ahead and 0.4 m to the left: the path leaves the point ahead on the right, and meets the one on the
  // left.
  const PlanePose X_GR{-1.0, -0.4, 0.0};
  const auto path = course_path(CourseParameters(), X_GR, Direction::kForward, 0.03, 3.0);
  EXPECT_FALSE(free_path(kOutline, 0.05, {at(1.0, 0.1)}, path).limited);
  EXPECT_TRUE(free_path(kOutline, 0.05, {at(0.9, 0.4)}, path).limited);
  EXPECT_TRUE(free_path(kOutline, 0.05, {at(1.0, 0.1)}, kAhead).limited);
}

TEST(FreePath, NothingBeyondTheGoalCounts) {
  const auto path = course_path(CourseParameters(), {-0.5, 0.0, 0.0}, Direction::kForward, 0.03, 3.0);
  EXPECT_FALSE(free_path(kOutline, 0.12, {at(0.5 + 0.22 + 0.125, 0.0)}, path).limited);
  EXPECT_TRUE(free_path(kOutline, 0.13, {at(0.5 + 0.22 + 0.125, 0.0)}, path).limited);
}

TEST(FreePath, TurningSweepsTheCorners) {
  const double reach = std::hypot(0.22, 0.18);
  const auto turn = turning_path(kOutline, M_PI, 0.03);
  EXPECT_FALSE(free_path(kOutline, 0.05, {at(reach + 0.06, 0.0)}, turn).limited);
  const FreePath free = free_path(kOutline, 0.05, {at(reach + 0.03, 0.0)}, turn);
  EXPECT_TRUE(free.limited);
  EXPECT_GT(free.length, 0.0);
}

TEST(FreePath, NamesTheSideForPeople) {
  EXPECT_EQ(side_of(0.8), "ahead on the left");
  EXPECT_EQ(side_of(-1.6), "on the right");
  EXPECT_EQ(side_of(M_PI), "behind");
  EXPECT_EQ(side_of(-M_PI), "behind");
}

}  // namespace
}  // namespace markservo::base_navigator
