#include "services/mmi/scene/pose_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace markservo::mmi {
namespace {

constexpr std::int64_t kSecond = 1'000'000;  // us

PoseReport pose(double time, double x, double heading = 0.0) {
  PoseReport report;
  report.utime = std::llround(time * static_cast<double>(kSecond));
  report.session = 5;
  report.state = LocalisationState::kLocalised;
  report.X_WR = {x, 2.0 * x, heading};
  report.delay = 0.19;
  return report;
}

TEST(PoseHistoryOfARobot, KnowsNothingBeforeTheFirstPose) {
  const PoseHistory history;
  EXPECT_FALSE(history.at(0));
  EXPECT_FALSE(history.delay());
}

TEST(PoseHistoryOfARobot, IsExactWhereAPoseIs) {
  PoseHistory history;
  history.add(pose(10.0, 1.0, 3.0));
  ASSERT_TRUE(history.at(10 * kSecond));
  EXPECT_EQ(history.at(10 * kSecond)->heading, 3.0);
  EXPECT_EQ(history.delay(), 0.19);
}

TEST(PoseHistoryOfARobot, LiesBetweenThePosesAround) {
  PoseHistory history;
  history.add(pose(10.0, 1.0));
  history.add(pose(10.4, 3.0));
  const auto X_WR = history.at(10 * kSecond + kSecond / 10);
  ASSERT_TRUE(X_WR);
  EXPECT_NEAR(X_WR->x, 1.5, 1e-12);
  EXPECT_NEAR(X_WR->y, 3.0, 1e-12);
}

TEST(PoseHistoryOfARobot, TurnsTheShorterWay) {
  PoseHistory history;
  history.add(pose(10.0, 0.0, M_PI - 0.1));
  history.add(pose(10.2, 0.0, -M_PI + 0.3));
  EXPECT_NEAR(history.at(10 * kSecond + kSecond / 10)->heading, -M_PI + 0.1, 1e-12);
}

TEST(PoseHistoryOfARobot, HoldsTheNewestForAMomentOnly) {
  PoseHistory history;
  history.add(pose(10.0, 1.0));
  EXPECT_TRUE(history.at(10 * kSecond + kSecond / 20));
  EXPECT_FALSE(history.at(10 * kSecond + kSecond / 5));
  EXPECT_FALSE(history.at(10 * kSecond - 1));
}

TEST(PoseHistoryOfARobot, BridgesNoLongGap) {
  PoseHistory history;
  history.add(pose(10.0, 1.0));
  history.add(pose(11.5, 2.0));
  EXPECT_FALSE(history.at(11 * kSecond));
}

TEST(PoseHistoryOfARobot, SaysNothingWhereARobotWasNotLocalised) {
  PoseHistory history;
  history.add(pose(10.0, 1.0));
  PoseReport lost = pose(10.2, 1.0);
  lost.state = LocalisationState::kLost;
  history.add(lost);
  EXPECT_FALSE(history.at(10 * kSecond + kSecond / 10));
  EXPECT_FALSE(history.at(10 * kSecond + kSecond / 5));
  EXPECT_TRUE(history.at(10 * kSecond));
}

TEST(PoseHistoryOfARobot, ForgetsWhatIsLongPast) {
  PoseHistory history;
  for (int i = 0; i <= 80; ++i) history.add(pose(10.0 + 0.1 * i, i));
  EXPECT_FALSE(history.at(12 * kSecond));
  EXPECT_TRUE(history.at(14 * kSecond));
}

TEST(PoseHistoryOfARobot, BeginsAnewWithAnotherWriterOrAClockSetBack) {
  PoseHistory history;
  history.add(pose(10.0, 1.0));
  PoseReport other = pose(10.1, 2.0);
  other.session = 6;
  history.add(other);
  EXPECT_FALSE(history.at(10 * kSecond));
  EXPECT_TRUE(history.at(other.utime));
  PoseReport earlier = pose(3.0, 2.0);
  earlier.session = 6;
  history.add(earlier);
  EXPECT_FALSE(history.at(other.utime));
  EXPECT_TRUE(history.at(3 * kSecond));
}

}  // namespace
}  // namespace markservo::mmi
