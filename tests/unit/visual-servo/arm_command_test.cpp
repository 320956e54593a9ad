// What is sent to arm and gripper, without any goal or picture.

#include "services/visual-servo/arm/arm_command.hpp"

#include "services/visual-servo/arm/gripper_command.hpp"
#include "services/visual-servo/arm/joint_limits.hpp"
#include "tests/unit/visual-servo/rig.hpp"

namespace markservo::visual_servo::test {
namespace {

constexpr double kFrame_s = 1.0 / 30.0;
const JointVector kStart(0.1, 1.2, -1.0);

JointSample sample_at(const JointVector& position) {
  JointSample sample;
  sample.utime = 1'000'000;
  sample.position = position;
  return sample;
}

class ArmCommandOfARobot : public testing::Test {
 protected:
  ArmCommandOfARobot() { command_.adopt(sample_at(kStart)); }

  std::string move(const ArmStep& step) { return command_.move(arm_, {}, step, sample_at(kStart), kFrame_s); }
  JointVector slow_down() {
    command_.slow_down(arm_, {}, 1'000'000, kFrame_s);
    return command_.position() - kStart;
  }

  robot::ArmDescription arm_ = *the_robot().arm;
  ArmCommand command_;
};

TEST_F(ArmCommandOfARobot, AdoptsThePostureOfTheShaftsOnceItIsDue) {
  ArmCommand fresh;
  EXPECT_FALSE(fresh.begun());
  command_.require_adoption();
  EXPECT_TRUE(command_.adoption_due());
  command_.adopt(sample_at({0.3, 1.0, -0.8}));
  EXPECT_FALSE(command_.adoption_due());
  EXPECT_TRUE(command_.begun());
  EXPECT_EQ(command_.position(), JointVector(0.3, 1.0, -0.8));
  EXPECT_LE(command_.speed_limit().maxCoeff(), 0.2) << "an arm that is elsewhere is not pulled there";
}

TEST_F(ArmCommandOfARobot, AStreamedStepIsSlowedDownGently) {
  EXPECT_EQ(move({{0.02, 0.0, 0.0}, true}), "");
  EXPECT_NEAR(slow_down()[0], 0.028, 1e-12);
  EXPECT_NEAR(slow_down()[0], 0.0312, 1e-12);
  EXPECT_NEAR(slow_down()[0], 0.03248, 1e-12);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(slow_down()[0], 0.03248, 1e-12) << "0.12 s are over";
}

TEST_F(ArmCommandOfARobot, AStepOfItsOwnIsNotGoneOnWith) {
  EXPECT_EQ(move({{0.02, 0.0, 0.0}, false, 1.0}), "");
  EXPECT_NEAR(slow_down()[0], 0.02, 1e-12);
}

TEST_F(ArmCommandOfARobot, HoldBreaksOffAtOnce) {
  move({{0.02, 0.0, 0.0}, true});
  command_.hold();
  EXPECT_NEAR(slow_down()[0], 0.02, 1e-12);
}

TEST_F(ArmCommandOfARobot, SlowingDownEndsAtAJointsLimit) {
  const JointVector at_limit(arm_.joints[0].max, 1.2, -1.0);
  const JointSample there = sample_at(at_limit - JointVector(0.02, 0.0, 0.0));
  command_.adopt(there);
  command_.move(arm_, {}, {{0.02, 0.0, 0.0}, true}, there, kFrame_s);
  slow_down();
  EXPECT_EQ(command_.position()[0], arm_.joints[0].max);
}

TEST_F(ArmCommandOfARobot, AStepThatLeadsTheShaftsTooFarIsNotMade) {
  move({{0.02, 0.0, 0.0}, true});
  EXPECT_EQ(move({{0.0, 0.75, 0.0}, true}), "the arm does not follow: joint shoulder");
  EXPECT_NEAR(slow_down()[0], 0.02, 1e-12) << "nor is the one before gone on with";
}

TEST_F(ArmCommandOfARobot, StreamedRampsEndJustBeforeTheNextCommand) {
  move({{0.05, -0.02, 0.0}, true});
  EXPECT_LT((command_.speed_limit() - JointVector(1.575, 0.63, 0.2)).norm(), 1e-12);
}

TEST_F(ArmCommandOfARobot, AStepWithoutASpeedOfItsOwnIsMadeInEightMilliseconds) {
  move({{0.05, 0.0, 0.0}, false, 1.75});
  EXPECT_EQ(command_.speed_limit(), JointVector::Constant(1.75));
  move({{0.008, -0.0004, 0.0}, false});
  EXPECT_LT((command_.speed_limit() - JointVector(1.0, 0.2, 0.2)).norm(), 1e-12);
  move({{0.05, 0.0, 0.0}, false});
  EXPECT_EQ(command_.speed_limit()[0], servo_speeds(arm_)[0]);
}

TEST_F(ArmCommandOfARobot, WhereTheArmRestsNothingIsFast) {
  JointHistory joints;
  joints.add(sample_at(kStart), servo_speeds(arm_));
  move({{0.008, 0.0, 0.0}, false});
  command_.relax({}, joints);
  EXPECT_GT(command_.speed_limit()[0], 0.9) << "not there yet";
  JointSample there = sample_at(kStart);
  there.utime += 100'000;
  there.position = command_.position();
  joints.add(there, servo_speeds(arm_));
  command_.relax({}, joints);
  EXPECT_EQ(command_.speed_limit(), JointVector::Constant(0.2));
}

TEST(GripperCommand, WhatPressesGoesOnPressingAndWhatMovesStops) {
  const robot::GripperDescription gripper = the_robot().arm->gripper;
  JointSample now = sample_at(kStart);
  now.gripper_opening = 0.03;
  GripperCommand command;
  command.adopt(gripper, now);
  EXPECT_EQ(command.opening(), 0.03);
  Goal closed;
  closed.gripper_force = 10.0;
  command.follow(gripper, closed, now.utime);
  command.adopt(gripper, now);
  EXPECT_EQ(command.opening(), 0.03) << "it was moving";
  command.follow(gripper, closed, now.utime);
  now.contact = true;
  command.observe(now, true);
  now.contact = false;  // a stop may end the report, not the grip
  command.adopt(gripper, now);
  EXPECT_EQ(command.opening(), 0.0);
  EXPECT_EQ(command.force(), 10.0);
}

}  // namespace
}  // namespace markservo::visual_servo::test
