// A joint whose word freezes for a while, as its time runs on, and then is true again.

#include <algorithm>
#include <cmath>
#include <tuple>

#include "tests/unit/visual-servo/rig.hpp"

namespace markservo::visual_servo::test {
namespace {

class FrozenJoint : public Rig, public testing::WithParamInterface<std::tuple<int, int>> {};

TEST_P(FrozenJoint, WhatItTaughtDoesNotLeadTheHandAside) {
  const auto [joint, after] = GetParam();
  frame();
  machine_.observe(servo_goal(), state_);
  frames(after);
  frozen_joint_ = joint;
  frozen_at_ = state_.joints.newest().position[joint];
  frames(20);
  frozen_joint_ = -1;
  double aside = 0.0;  // m
  double deep = 0.0;   // m
  for (int i = 0; i < 150; ++i) {
    frame();
    aside = std::max(aside, std::abs(arm_.grip_point().x() - goal_point_.x()));
    deep = std::max(deep, arm_.grip_point().y() - goal_point_.y());
  }
  EXPECT_LT(aside, 0.008) << "what stands beside is 10 mm from the fingers";
  const auto& gripper = robot_.arm->gripper;
  const double to_the_palm = gripper.finger_length - gripper.finger_beyond_grip_point - servo_goal().p_TG_C.y();
  EXPECT_LT(deep, to_the_palm) << "there the palm would push the object";
  EXPECT_EQ(frame().status.state, ServoState::kConverged);
}

INSTANTIATE_TEST_SUITE_P(EachJointAtEachStage, FrozenJoint,
                         testing::Combine(testing::Range(0, robot::kNumJoints), testing::Range(1, 20, 2)));

class OnePictureWithAWrongHand : public Rig, public testing::WithParamInterface<int> {};

TEST_P(OnePictureWithAWrongHand, MovesTheHandByNoMoreThanItsNoise) {
  frame();
  machine_.observe(servo_goal(), state_);
  frames(GetParam());
  hand_off_ = {0.03, 0.0, 0.0};
  frame();
  hand_off_.setZero();
  double aside = 0.0;  // m
  for (int i = 0; i < 60; ++i) {
    frame();
    aside = std::max(aside, std::abs(arm_.grip_point().x() - goal_point_.x()));
  }
  EXPECT_LT(aside, 0.006);
  EXPECT_EQ(frames_until(ServoState::kConverged, 120).status.state, ServoState::kConverged);
}

INSTANTIATE_TEST_SUITE_P(AtEachStage, OnePictureWithAWrongHand, testing::Range(1, 20));

using LyingJoints = Rig;

TEST_F(LyingJoints, AConstantLieDoesNotWalkAnArmThatHolds) {
  Goal hold = posture_goal(start_);
  hold.kind = GoalKind::kHold;
  machine_.observe(hold, state_);
  frames(10);
  const Eigen::Vector3d before = arm_.grip_point();
  joints_off_ = {0.06, 0.0, 0.0};
  const Output output = frames(300);
  EXPECT_LT((arm_.grip_point() - before).norm(), 0.02) << "once by the lie, 0.06 rad";
  EXPECT_EQ(output.status.reason, "the arm does not rest where it is told to");
}

}  // namespace
}  // namespace markservo::visual_servo::test
