// What the base is told: whether it may move, which goal, and where that lies.

#include <gtest/gtest.h>

#include <cmath>

#include "services/base-navigator/inputs/followed_goal.hpp"
#include "services/base-navigator/inputs/motion_enable.hpp"

namespace markservo::base_navigator {
namespace {

using geometry::PlanePose;

constexpr std::int64_t kStart = 1'700'000'000'000'000;

TEST(MotionEnable, IsGivenByAStopThatIsKnownToBeReleased) {
  MotionEnable enable;
  EXPECT_EQ(enable.why_stopped(), "no STOP_STATE of the base yet");
  EXPECT_FALSE(enable.latched());
  enable.observe_stop(true, "");
  EXPECT_EQ(enable.why_stopped(), "STOP is latched");
  EXPECT_TRUE(enable.latched());
  enable.observe_stop(true, "a hand");
  EXPECT_EQ(enable.why_stopped(), "a hand");
  enable.observe_stop(false, "");
  EXPECT_EQ(enable.why_stopped(), "");
}

TEST(MotionEnable, IsNotGivenWhileTwoContradictEachOther) {
  MotionEnable enable;
  enable.observe_stop(false, "");
  enable.observe_conflict("two write ROBOT_POSE");
  EXPECT_EQ(enable.why_stopped(), "two write ROBOT_POSE");
  enable.observe_conflict("");
  EXPECT_EQ(enable.why_stopped(), "");
}

class GoalOfTheRobotsFrame : public testing::Test {
 protected:
  GoalOfTheRobotsFrame() {
    odometry_.track = 0.32;
    odometry_.wheel_speed = 1.7;
    for (int i = 0; i <= 50; ++i) wheels(0.0);
    Goal goal;
    goal.utime = utime_;
    goal.session = 5;
    goal.id = 1;
    goal.kind = GoalKind::kDrive;
    goal.frame = GoalFrame::kRobot;
    goal.pose = {0.8, 0.3, 0.4};
    EXPECT_EQ(goal_.observe(trust_, goal, track_, false), motion::GoalHeard::kNew);
    EXPECT_EQ(goal_.refusal(), "");
  }

  // Both wheels `way` (m) farther, 20 ms later.
  void wheels(double way) {
    utime_ += 20'000;
    way_ += way;
    track_.add(odometry_, {utime_, way_, way_});
  }

  OdometryParameters odometry_;
  TrustParameters trust_;
  OdometryTrack track_;
  FollowedGoal goal_;
  std::int64_t utime_ = kStart;
  double way_ = 0.0;
};

TEST_F(GoalOfTheRobotsFrame, LiesWhereItWasHeardHoweverFarTheRobotHasGoneBeforeItHasAPose) {
  wheels(0.02);
  wheels(0.02);
  const PlanePose X_WR{2.04, 1.0, 0.0};
  const auto X_WG = goal_.place(X_WR, track_);
  ASSERT_TRUE(X_WG.has_value());
  EXPECT_NEAR(X_WG->x, 2.8, 1e-9);
  EXPECT_NEAR(X_WG->y, 1.3, 1e-9);
  EXPECT_NEAR(X_WG->heading, 0.4, 1e-9);
  EXPECT_EQ(goal_.place({7.0, 7.0, 0.0}, track_)->x, X_WG->x);
}

TEST_F(GoalOfTheRobotsFrame, IsRefusedWhenTheWheelsWereInterruptedBeforeItHadAPlace) {
  wheels(8.3);
  EXPECT_FALSE(goal_.place({}, track_).has_value());
  EXPECT_NE(goal_.refusal().find("WHEEL_ODOMETRY was interrupted"), std::string::npos) << goal_.refusal();
}

TEST_F(GoalOfTheRobotsFrame, SaysThatItWasDroppedUntilTheNextOne) {
  goal_.drop("the base began anew");
  EXPECT_FALSE(goal_.goal().has_value());
  EXPECT_EQ(goal_.why_none(), "the base began anew: the goal was dropped");
  goal_.drop("once more");
  EXPECT_EQ(goal_.why_none(), "the base began anew: the goal was dropped");
}

}  // namespace
}  // namespace markservo::base_navigator
