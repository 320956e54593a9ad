#include <gtest/gtest.h>

#include <algorithm>

#include "common/robot/workspace.hpp"
#include "services/task-manager/plans/lift_plan.hpp"
#include "services/task-manager/watches/lift_check.hpp"
#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

constexpr LiftDemand kDemand{0.012, 0.005, 0.33};

class LiftAt : public ::testing::TestWithParam<double> {
 protected:
  robot::RobotDescription robot_ = default_robot();
  const robot::ArmDescription& arm_ = *robot_.arm;
  const robot::GripDescription& grip_ = *robot_.find_mark("red_book")->grip;
  Parameters parameters_;
  Eigen::Vector3d p_CT_{0.0325, GetParam(), 0.032};
  Eigen::Vector3d p_CG_ = p_CT_ + grip_.p_TG;
  robot::JointVector q_ = robot::inverse_kinematics(arm_, p_CG_, 0.0).q;
};

TEST_P(LiftAt, GoesStraightUpTwelveMillimetres) {
  const PosturePath path = plan_lift(arm_, parameters_, grip_, q_, p_CG_, 0.012, 0.01);
  ASSERT_TRUE(path.reachable());
  EXPECT_NEAR(path.end_point().z() - p_CG_.z(), 0.012, 1e-6);
  robot::JointVector from = q_;
  for (const Move& move : path.moves()) {
    for (double part = 0.25; part <= 1.0; part += 0.25) {
      const Eigen::Vector3d off = robot::grip_point(arm_, from + part * (move.q - from)) - p_CG_;
      EXPECT_LT(off.head<2>().norm(), 0.0002);
    }
    EXPECT_DOUBLE_EQ(move.opening, 0.01);
    from = move.q;
  }
}

TEST_P(LiftAt, ReachesThirtyMillimetresBendingTowardsTheRobotWhereItMust) {
  const PosturePath path = plan_lift(arm_, parameters_, grip_, q_, p_CG_, 0.030, 0.01);
  ASSERT_TRUE(path.reachable());
  EXPECT_NEAR(path.end_point().z() - p_CG_.z(), 0.030, 1e-6);
  EXPECT_LE(path.end_point().y(), p_CG_.y() + 1e-6);
  EXPECT_GT(path.end_point().y(), p_CG_.y() - 0.01);
}

TEST_P(LiftAt, KeepsTheMarkInViewForTheCheck) {
  const double height = check_height(robot_, parameters_, *robot_.find_mark("red_book"), p_CT_);
  EXPECT_GE(height, 0.006);
  EXPECT_LE(height, 0.012);
  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();
  X_CT.translation() = p_CT_ + Eigen::Vector3d(0.0, 0.0, height);
  EXPECT_GT(robot::view_margin_px(robot_.cameras, X_CT, 0.025), 0.0);
}

TEST_P(LiftAt, IsUndoneByPuttingBack) {
  const PosturePath up = plan_lift(arm_, parameters_, grip_, q_, p_CG_, 0.030, 0.01);
  const Eigen::Vector3d p_CG_back = p_CG_ - Eigen::Vector3d(0.0, 0.05, 0.0);
  const PosturePath path = plan_put_back(arm_, parameters_, up.end(), p_CG_, p_CG_back, 0.01);
  ASSERT_TRUE(path.reachable());
  EXPECT_LT((path.end_point() - p_CG_back).norm(), 1e-6);
  const auto opens =
      std::find_if(path.moves().begin(), path.moves().end(), [](const Move& move) { return move.opening > 0.04; });
  ASSERT_NE(opens, path.moves().end());
  EXPECT_LT((robot::grip_point(arm_, opens->q) - p_CG_).norm(), 1e-6) << "opens at its place, not before";
}

TEST_P(LiftAt, TellsABookThatComesAlongFromOneThatStays) {
  const PosturePath up = plan_lift(arm_, parameters_, grip_, q_, p_CG_, 0.012, 0.01);
  const LiftView before{p_CT_, robot::hand_mark(arm_, q_), q_};
  LiftView after{robot::grip_pose(arm_, up.end()) * (robot::grip_pose(arm_, q_).inverse() * p_CT_),
                 robot::hand_mark(arm_, up.end()), up.end()};
  const LiftVerdict along = check_lift(arm_, before, after, kDemand);
  EXPECT_TRUE(along.came_along) << along.reason;
  EXPECT_LT(along.error.norm(), 1e-6);
  after.p_CT = p_CT_;
  const LiftVerdict stayed = check_lift(arm_, before, after, kDemand);
  EXPECT_FALSE(stayed.came_along) << stayed.reason;
  EXPECT_LT(stayed.error.z(), -0.008);
}

TEST_P(LiftAt, TakesABookThatHangsBetweenThePadsForOneThatComesAlong) {
  const PosturePath up = plan_lift(arm_, parameters_, grip_, q_, p_CG_, 0.012, 0.01);
  const LiftView before{p_CT_, robot::hand_mark(arm_, q_), q_};
  const Eigen::Vector3d rise = robot::grip_point(arm_, up.end()) - robot::grip_point(arm_, q_);
  const LiftView after{p_CT_ + rise, robot::hand_mark(arm_, up.end()), up.end()};
  const LiftVerdict hangs = check_lift(arm_, before, after, kDemand);
  EXPECT_TRUE(hangs.came_along) << hangs.reason;
  EXPECT_LT(hangs.error.norm(), 1e-6);
}

TEST_P(LiftAt, TellsABookThatSlidesOutOfTheHand) {
  const PosturePath up = plan_lift(arm_, parameters_, grip_, q_, p_CG_, 0.012, 0.01);
  const LiftView before{p_CT_, robot::hand_mark(arm_, q_), q_};
  const Eigen::Vector3d rise = robot::grip_point(arm_, up.end()) - robot::grip_point(arm_, q_);
  for (const Eigen::Vector3d& slide :
       {Eigen::Vector3d(0.006, 0.0, 0.0), Eigen::Vector3d(0.0, 0.006, 0.0), Eigen::Vector3d(0.0, 0.0, -0.006)}) {
    const LiftView after{p_CT_ + rise + slide, robot::hand_mark(arm_, up.end()), up.end()};
    const LiftVerdict slid = check_lift(arm_, before, after, kDemand);
    EXPECT_FALSE(slid.came_along) << slide.transpose() << ": " << slid.reason;
  }
}

TEST_P(LiftAt, WhereNeitherMarkMovedNothingCameAlong) {
  const PosturePath up = plan_lift(arm_, parameters_, grip_, q_, p_CG_, 0.012, 0.01);
  const LiftView before{p_CT_, robot::hand_mark(arm_, q_), q_};
  // An arm that stuck though its joint states went up: the marks kept their places to each other.
  const LiftView stuck{before.p_CT, before.p_CM, up.end()};
  constexpr LiftDemand kLenient{0.012, 0.010, 0.33};
  EXPECT_LT(check_lift(arm_, before, stuck, kLenient).error.norm(), kLenient.tolerance);
  EXPECT_FALSE(check_lift(arm_, before, stuck, kLenient).came_along);
  // Joint states that did not go up either.
  EXPECT_FALSE(check_lift(arm_, before, before, kDemand).came_along);
}

INSTANTIATE_TEST_SUITE_P(Depths, LiftAt, ::testing::Values(0.20, 0.25, 0.30));

TEST(Lift, KeepsTheMiddleOfATurningObjectBetweenItsNeighbours) {
  const robot::RobotDescription robot = default_robot();
  const Parameters parameters;
  const robot::GripDescription& grip = *robot.find_mark("red_book")->grip;
  const Eigen::Vector3d p_CG = Eigen::Vector3d(0.10, 0.30, 0.032) + grip.p_TG;
  const robot::JointVector q = robot::inverse_kinematics(*robot.arm, p_CG, 0.0).q;
  const PosturePath path = plan_lift(*robot.arm, parameters, grip, q, p_CG, 0.012, 0.01);
  ASSERT_TRUE(path.reachable());
  const Eigen::Vector3d hand = robot::grip_pose(*robot.arm, path.end()).linear().col(1);
  const double object_middle = 0.045;  // m behind the grip: half of 12 cm, and 1.5 cm of that before it
  const double middle_x = path.end_point().x() + object_middle * hand.head<2>().normalized().x();
  EXPECT_NEAR(middle_x, p_CG.x(), 0.0002);
  EXPECT_LT(path.end_point().x(), p_CG.x() - 0.008) << "it had to give way";
}

TEST(MarkAverage, CountsEachFrameOnce) {
  MarkAverage average;
  average.add(1, {1.0, 0.0, 0.0});
  average.add(1, {1.0, 0.0, 0.0});
  average.add(2, {3.0, 0.0, 0.0});
  EXPECT_EQ(average.count(), 2);
  EXPECT_DOUBLE_EQ(average.mean().x(), 2.0);
}

}  // namespace
}  // namespace markservo::task_manager
