#include "services/task-manager/plans/carry_plan.hpp"

#include <gtest/gtest.h>

#include "services/task-manager/plans/box_clearance.hpp"
#include "services/task-manager/plans/lift_plan.hpp"
#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

constexpr double kClosed = 0.01;  // m

class CarryFrom : public ::testing::TestWithParam<std::pair<double, double>> {
 protected:
  robot::RobotDescription robot_ = default_robot();
  const robot::ArmDescription& arm_ = *robot_.arm;
  const robot::GripDescription& grip_ = *robot_.find_mark("red_book")->grip;
  Parameters parameters_;
  Eigen::Vector3d p_CT_{GetParam().first, GetParam().second, 0.032};
  Eigen::Vector3d p_CG_ = p_CT_ + grip_.p_TG;
  robot::JointVector q_ = robot::inverse_kinematics(arm_, p_CG_, 0.0).q;
  PosturePath up_ = plan_lift(arm_, parameters_, grip_, q_, p_CG_, 0.030, kClosed);
  CarryPlan plan_ = plan_carry(arm_, parameters_, grip_, {p_CT_, q_}, up_.end(), kClosed);
};

TEST_P(CarryFrom, KeepsTheBookClearOfItsNeighboursAndTheShelf) {
  ASSERT_EQ(plan_.trouble, "");
  EXPECT_GE(plan_.clearance, 0.004);
  EXPECT_DOUBLE_EQ(path_clearance(arm_, parameters_.carry, grip_, {p_CT_, q_}, up_.end(), plan_.moves),
                   plan_.clearance);
}

TEST_P(CarryFrom, GoesByPosturesTheArmCanTake) {
  ASSERT_EQ(plan_.trouble, "");
  for (const Move& move : plan_.moves) {
    for (int i = 0; i < robot::kNumJoints; ++i) {
      EXPECT_GT(move.q[i], arm_.joints[static_cast<std::size_t>(i)].min);
      EXPECT_LT(move.q[i], arm_.joints[static_cast<std::size_t>(i)].max);
    }
    const auto ik = robot::inverse_kinematics(arm_, robot::grip_point(arm_, move.q), 0.0);
    ASSERT_EQ(ik.status, robot::ReachStatus::kReachable);
    EXPECT_LT((ik.q - move.q).norm(), 1e-6);
    EXPECT_DOUBLE_EQ(move.opening, kClosed);
  }
}

TEST_P(CarryFrom, EndsOnTheSideTableWithTheBookUpright) {
  ASSERT_EQ(plan_.trouble, "");
  const Eigen::Vector3d p_CG = robot::grip_point(arm_, plan_.end);
  EXPECT_NEAR(p_CG.z(), p_CG_.z() + parameters_.carry.place_gap, 1e-6);
  const double tilt = plan_.end[1] + plan_.end[2] - q_[1] - q_[2];
  EXPECT_LT(std::abs(tilt), 0.05);
  // Both ends of the book over the table of config/scenes/shelf.yaml.
  for (const double along : {0.0, 0.09}) {
    const Eigen::Vector3d point = robot::grip_pose(arm_, plan_.end) * Eigen::Vector3d(0.0, along, 0.0);
    EXPECT_LT(point.x(), -0.11);
    EXPECT_GT(point.x(), -0.36);
    EXPECT_LT(point.y(), 0.22);
  }
}

TEST_P(CarryFrom, ReleasesBeforeTheHandBacksOff) {
  const PosturePath path = plan_release(arm_, parameters_, plan_.end, kClosed);
  ASSERT_TRUE(path.reachable());
  EXPECT_DOUBLE_EQ(path.moves().front().opening, arm_.gripper.opening_max);
  EXPECT_GT(path.moves().front().dwell, 0.5);
  EXPECT_GT((path.end_point() - robot::grip_point(arm_, plan_.end)).norm(), 0.06);
}

INSTANTIATE_TEST_SUITE_P(Workspace, CarryFrom,
                         ::testing::Values(std::pair{0.0325, 0.25}, std::pair{-0.0175, 0.25}, std::pair{0.0825, 0.25},
                                           std::pair{0.0325, 0.225}, std::pair{0.0325, 0.30}));

TEST(CarryPlan, SeesABookThatIsTurnedBetweenItsNeighbours) {
  const auto robot = default_robot();
  const auto& grip = *robot.find_mark("red_book")->grip;
  const Eigen::Vector3d p_CT(0.0325, 0.25, 0.032);
  const auto q = robot::inverse_kinematics(*robot.arm, p_CT + grip.p_TG, 0.0).q;
  Move turn;
  turn.q = q + robot::JointVector(0.3, 0.0, 0.0);
  EXPECT_LT(path_clearance(*robot.arm, CarryParameters(), grip, {p_CT, q}, q, {turn}), 0.0);
}

TEST(CarryPlan, SaysWhyABookCannotBeCarried) {
  const auto robot = default_robot();
  const auto& grip = *robot.find_mark("red_book")->grip;
  const Eigen::Vector3d p_CT(0.0325, 0.20, 0.032);
  const auto q = robot::inverse_kinematics(*robot.arm, p_CT + grip.p_TG, 0.0).q;
  const auto up = plan_lift(*robot.arm, Parameters(), grip, q, p_CT + grip.p_TG, 0.030, kClosed);
  EXPECT_NE(plan_carry(*robot.arm, Parameters(), grip, {p_CT, q}, up.end(), kClosed).trouble, "");
}

TEST(BoxClearance, OfBoxesSideBySideIsTheirGap) {
  Box a;
  a.half_size << 0.1, 0.2, 0.3;
  Box b = a;
  b.X_CB.translation() << 0.25, 0.0, 0.0;
  EXPECT_NEAR(box_clearance(a, b), 0.05, 1e-12);
}

TEST(BoxClearance, OfBoxesThatOverlapIsNegative) {
  Box a;
  a.half_size << 0.1, 0.1, 0.1;
  Box b = a;
  b.X_CB.translation() << 0.15, 0.0, 0.0;
  EXPECT_NEAR(box_clearance(a, b), -0.05, 1e-12);
}

TEST(BoxClearance, SeesATurnedEdgeReachFurther) {
  Box a;
  a.half_size << 0.1, 0.1, 0.1;
  Box b = a;
  b.X_CB.translation() << 0.25, 0.0, 0.0;
  b.X_CB.linear() = Eigen::AngleAxisd(M_PI / 4.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_NEAR(box_clearance(a, b), 0.25 - 0.1 - 0.1 * std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace markservo::task_manager
