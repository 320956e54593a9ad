#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "tests/unit/simulator/test_world.hpp"

namespace markservo::simulator {
namespace {

using Eigen::Vector3d;

constexpr double kOpen = 0.05;  // m

Vector3d grip_goal(const Vector3d& mark) {
  return mark + test_robot().find_mark("red_book")->grip->p_TG;
}

// From the home posture to a place before the books, then in between them.
bool approach(World& world, const Vector3d& goal) {
  const Vector3d before = goal + Vector3d(0.0, -0.07, 0.0);
  const auto ik = robot::inverse_kinematics(*test_robot().arm, before, 0.0);
  if (ik.status != robot::ReachStatus::kReachable) return false;
  world.command(posture(ik.q, kOpen));
  wait(world, 2.0);
  return move_straight(world, before, goal, kOpen);
}

struct Place {
  double x;
  double y;
};

void PrintTo(const Place& place, std::ostream* out) {
  *out << "x " << place.x << " m, y " << place.y << " m";
}

class Grip : public testing::TestWithParam<Place> {};

TEST_P(Grip, TheBookIsLiftedByFrictionAlone) {
  const Vector3d mark(GetParam().x, GetParam().y, 0.032);
  World world = test_world(test_settings({{"books.x", mark.x()}, {"books.y", mark.y()}}));
  const Vector3d goal = grip_goal(mark);
  ASSERT_TRUE(approach(world, goal));
  EXPECT_FALSE(world.truth().arm_touched) << world.truth().touched;

  world.command(posture(world.arm().position, 0.0));
  wait(world, 1.0);
  const BodyTruth gripped = body_of(world.truth(), "red_book");
  EXPECT_TRUE(gripped.touches_left_finger && gripped.touches_right_finger);
  ASSERT_TRUE(move_straight(world, goal, goal + Vector3d(0.0, 0.0, 0.03), 0.0));
  wait(world, 1.0);

  const WorldTruth truth = world.truth();
  const BodyTruth lifted = body_of(truth, "red_book");
  EXPECT_GE(lifted.height_gain, 0.020);
  EXPECT_TRUE(lifted.touches_left_finger && lifted.touches_right_finger);
  EXPECT_FALSE(lifted.touches_other);
  for (const char* neighbour : {"yellow_book", "blue_book"}) {
    EXPECT_NEAR(body_of(truth, neighbour).height_gain, 0.0, 1e-3) << neighbour;
  }
  // The book's weight bends the arm by less than 0.05 degrees.
  EXPECT_LT((truth.shaft - world.arm().position).cwiseAbs().maxCoeff(), 0.05 * 0.01745);
}

INSTANTIATE_TEST_SUITE_P(OverTheWorkspace, Grip,
                         testing::Values(Place{0.0, 0.20}, Place{0.0325, 0.20}, Place{0.06, 0.20}, Place{0.0, 0.25},
                                         Place{0.0325, 0.25}, Place{0.07, 0.25}, Place{0.0, 0.29}, Place{0.0325, 0.29},
                                         Place{0.08, 0.29}));

TEST(Grip, ABookIsNotLiftedWithoutFriction) {
  const Vector3d mark(0.0325, 0.25, 0.032);
  World world = test_world(test_settings({{"gripper.friction", 0.05}}));
  const Vector3d goal = grip_goal(mark);
  ASSERT_TRUE(approach(world, goal));
  world.command(posture(world.arm().position, 0.0));
  wait(world, 1.0);
  ASSERT_TRUE(move_straight(world, goal, goal + Vector3d(0.0, 0.0, 0.03), 0.0));
  EXPECT_LT(body_of(world.truth(), "red_book").height_gain, 0.015);
}

TEST(Grip, TheBookSlipsByLessThanAMillimetreInTenSeconds) {
  const Vector3d goal = grip_goal({0.0325, 0.25, 0.032});
  World world = test_world(test_settings());
  ASSERT_TRUE(approach(world, goal));
  world.command(posture(world.arm().position, 0.0));
  wait(world, 1.0);
  ASSERT_TRUE(move_straight(world, goal, goal + Vector3d(0.0, 0.0, 0.03), 0.0));
  const double height = body_of(world.truth(), "red_book").height_gain;
  wait(world, 10.0);
  EXPECT_NEAR(body_of(world.truth(), "red_book").height_gain, height, 0.001);
}

TEST(Carry, ABookIsPutDownOnTheSideTable) {
  const robot::ArmDescription arm = *test_robot().arm;
  const Vector3d goal = grip_goal({0.0325, 0.25, 0.032});
  World world = test_world(test_settings());
  ASSERT_TRUE(approach(world, goal));
  world.command(posture(world.arm().position, 0.0));
  wait(world, 1.0);
  const Vector3d lifted = goal + Vector3d(0.0, 0.0, 0.03);
  const Vector3d back = lifted + Vector3d(0.0, -0.16, 0.0);
  ASSERT_TRUE(move_straight(world, goal, lifted, 0.0));
  ASSERT_TRUE(move_straight(world, lifted, back, 0.0));
  robot::JointVector turned = world.arm().position;
  turned[0] = 1.4;
  world.command(posture(turned, 0.0, 0.7));
  wait(world, 3.0);
  // Out again to the grip's own distance: there the book is upright as it stood.
  const double radius = (goal - arm.p_CA).head<2>().norm();
  const Vector3d over(arm.p_CA.x() - radius * std::sin(1.4), arm.p_CA.y() + radius * std::cos(1.4), lifted.z());
  const Vector3d down(over.x(), over.y(), goal.z() - 0.002);
  ASSERT_TRUE(move_straight(world, robot::grip_point(arm, turned), over, 0.0));
  ASSERT_TRUE(move_straight(world, over, down, 0.0));
  world.command(posture(world.arm().position, kOpen));
  wait(world, 1.0);
  ASSERT_TRUE(
      move_straight(world, down, robot::grip_point(arm, turned) + Vector3d(0.0, 0.0, down.z() - lifted.z()), kOpen));

  const WorldTruth truth = world.truth();
  const BodyTruth book = body_of(truth, "red_book");
  EXPECT_GT(book.X_CB.linear()(2, 2), 0.999) << "it stands upright";
  EXPECT_NEAR(book.height_gain, 0.0, 0.002);
  EXPECT_LT(book.X_CB.translation().x(), -0.11);
  EXPECT_FALSE(book.touches_left_finger || book.touches_right_finger);
  for (const char* neighbour : {"yellow_book", "blue_book"}) {
    const auto& other = body_of(truth, neighbour);
    EXPECT_GT(std::abs(other.X_CB.linear()(0, 0)), 0.9999) << neighbour << " was knocked";
  }
}

TEST(Carry, ABookThatTheCarriedOneKnocksIsOnlyPushed) {
  const Vector3d goal = grip_goal({0.0325, 0.25, 0.032});
  World world = test_world(test_settings());
  ASSERT_TRUE(approach(world, goal));
  world.command(posture(world.arm().position, 0.0));
  wait(world, 1.0);
  const Vector3d lifted = goal + Vector3d(0.0, 0.0, 0.03);
  ASSERT_TRUE(move_straight(world, goal, lifted, 0.0));
  // 5 cm less than is needed to turn freely.
  ASSERT_TRUE(move_straight(world, lifted, lifted + Vector3d(0.0, -0.11, 0.0), 0.0));
  robot::JointVector turned = world.arm().position;
  turned[0] = 1.4;
  world.command(posture(turned, 0.0, 0.74));
  wait(world, 3.0);
  const BodyTruth neighbour = body_of(world.truth(), "blue_book");
  EXPECT_LT(neighbour.X_CB.linear()(0, 0), 0.9999) << "it was not knocked: this test shows nothing";
  EXPECT_LT(neighbour.height_gain, 0.02) << "it may fall, not fly";
  EXPECT_LT((neighbour.X_CB.translation() - Vector3d(-0.0175, 0.31, -0.03)).norm(), 1.0);
}

TEST(Carry, TheArmsWayToTheSideTableTouchesNothing) {
  const robot::ArmDescription arm = *test_robot().arm;
  World world = test_world(test_settings({{"books.y", 0.8}}));
  for (const double radius : {0.06, 0.15, 0.20, 0.25}) {
    const auto ik = robot::inverse_kinematics(arm, arm.p_CA + Vector3d(0.0, radius, 0.43), 0.0);
    ASSERT_EQ(ik.status, robot::ReachStatus::kReachable);
    for (const double yaw : {0.0, 1.4}) {
      world.command(posture({yaw, ik.q[1], ik.q[2]}, kOpen, 2.0));
      wait(world, 1.5);
    }
  }
  EXPECT_FALSE(world.truth().arm_touched) << world.truth().touched;
}

}  // namespace
}  // namespace markservo::simulator
