#include "services/task-manager/plans/approach_plan.hpp"

#include <gtest/gtest.h>

#include "common/robot/arm_kinematics.hpp"
#include "common/robot/workspace.hpp"
#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

class ApproachPlanOf : public ::testing::TestWithParam<std::pair<double, double>> {
 protected:
  robot::RobotDescription robot_ = default_robot();
  const robot::MarkDescription& target_ = *robot_.find_mark("red_book");
  Parameters parameters_;
  Eigen::Vector3d p_CT_{GetParam().first, GetParam().second, 0.032};
};

TEST_P(ApproachPlanOf, EndsWhereTheHandsMarkIsInBothImages) {
  const auto plan = plan_approach(robot_, parameters_, target_, p_CT_, {robot_.arm->home, 0.05});
  ASSERT_EQ(plan.trouble, "");
  const auto& q = plan.moves.back().q;
  const Eigen::Vector3d wanted = p_CT_ + target_.grip->p_TG - Eigen::Vector3d(0.0, plan.standoff, 0.0);
  EXPECT_LT((robot::grip_point(*robot_.arm, q) - wanted).norm(), 1e-6);
  EXPECT_GE(robot::view_margin_px(robot_.cameras, robot::hand_mark_pose(*robot_.arm, q), 0.020), 8.0);
}

TEST_P(ApproachPlanOf, PassesTheSpinesOnTheLineOfApproachOnly) {
  const auto plan = plan_approach(robot_, parameters_, target_, p_CT_, {robot_.arm->home, 0.05});
  robot::JointVector from = robot_.arm->home;
  for (const Move& move : plan.moves) {
    for (double part = 0.1; part <= 1.0; part += 0.1) {
      const Eigen::Vector3d p_CG = robot::grip_point(*robot_.arm, from + part * (move.q - from));
      const double tip = p_CG.y() + robot_.arm->gripper.finger_beyond_grip_point;
      if (tip < p_CT_.y()) continue;
      EXPECT_NEAR(p_CG.x(), p_CT_.x(), 0.001);
      EXPECT_NEAR(p_CG.z(), (p_CT_ + target_.grip->p_TG).z(), 0.001);
    }
    from = move.q;
  }
}

TEST_P(ApproachPlanOf, BacksOffToAPostureBeforeTheSpines) {
  const auto plan = plan_approach(robot_, parameters_, target_, p_CT_, {robot_.arm->home, 0.05});
  EXPECT_LE(plan.p_CG_first.y() + robot_.arm->gripper.finger_beyond_grip_point, p_CT_.y() - 0.0049);
}

INSTANTIATE_TEST_SUITE_P(Workspace, ApproachPlanOf,
                         ::testing::Values(std::pair{0.0325, 0.25}, std::pair{-0.0175, 0.25}, std::pair{0.0825, 0.25},
                                           std::pair{0.0325, 0.20}, std::pair{0.0, 0.20}, std::pair{0.0325, 0.30},
                                           std::pair{0.0825, 0.30}));

TEST(ApproachPlan, OpensAClosedHandBeforeItMoves) {
  const auto robot = default_robot();
  const auto plan =
      plan_approach(robot, Parameters(), *robot.find_mark("red_book"), {0.0325, 0.25, 0.032}, {robot.arm->home, 0.0});
  ASSERT_FALSE(plan.moves.empty());
  EXPECT_TRUE(plan.moves.front().hold);
  EXPECT_DOUBLE_EQ(plan.moves.front().opening, 0.05);
  EXPECT_GT(plan.moves.front().dwell, 0.5);
}

TEST(ApproachPlan, SaysWhyThereIsNoWay) {
  const auto robot = default_robot();
  const auto plan =
      plan_approach(robot, Parameters(), *robot.find_mark("red_book"), {0.0325, 0.50, 0.032}, {robot.arm->home, 0.05});
  EXPECT_EQ(plan.trouble.rfind("no way to a posture before the target: beyond the arm's reach: 0.", 0), 0U)
      << plan.trouble;
}

TEST(HomePlan, LeavesTheSideTableAlongTheArm) {
  const auto robot = default_robot();
  const auto ik = robot::inverse_kinematics(*robot.arm, {-0.166, 0.113, -0.018}, 0.0);
  const PosturePath path = plan_home(*robot.arm, Parameters(), {ik.q, 0.05});
  ASSERT_TRUE(path.reachable());
  ASSERT_GT(path.moves().size(), 3u);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(path.moves()[i].q[0], ik.q[0], 1e-6) << "the fingers do not turn";
  EXPECT_EQ(path.end(), robot.arm->home);
}

}  // namespace
}  // namespace markservo::task_manager
