// A goal is followed as long as its sender repeats it.

#include "tests/unit/visual-servo/rig.hpp"

namespace markservo::visual_servo::test {
namespace {

class GoalAge : public Rig {
 protected:
  // So many frames with the goal repeated every 0.2 s, bearing the time of the frame that the sender saw last.
  Output frames_at_5_hz(int count) {
    sender_lives_ = false;
    Output output;
    for (int i = 0; i < count; ++i) {
      if (i % 6 == 0) repeat_goal(last_pose_.utime);
      output = frame();
      EXPECT_NE(output.status.state, ServoState::kStale) << output.status.reason;
    }
    return output;
  }
};

TEST_F(GoalAge, AServoGoalWhoseSenderDiedBringsTheArmToRest) {
  Goal slow = servo_goal();
  slow.speed = 0.03;
  machine_.observe(slow, state_);
  frames(10);
  sender_lives_ = false;
  const Output output = frames_until(ServoState::kStale, 20);  // 0.67 s
  EXPECT_NE(output.status.reason.find("s older than JOINT_STATE; allowed: 0.60 s"), std::string::npos)
      << output.status.reason;
  EXPECT_FALSE(output.status.settled);
  EXPECT_EQ(output.status.goal_id, 1);
  frames(5);
  const JointVector rest = state_.command.position();
  const double y = arm_.grip_point().y();
  EXPECT_LT(y, goal_point_.y() - 0.05) << "far from its end";
  EXPECT_EQ(frames(30).command->position, rest);
  EXPECT_NEAR(arm_.grip_point().y(), y, 1e-6);
}

TEST_F(GoalAge, APostureGoesOnWhenItIsRepeatedAgain) {
  frame();
  const JointVector goal = start_ + JointVector(0.6, -0.2, 0.1);
  Goal slow = posture_goal(goal);
  slow.speed = 0.03;
  machine_.observe(slow, state_);
  frames(5);
  sender_lives_ = false;
  frames_until(ServoState::kStale, 20);
  frames(10);
  sender_lives_ = true;
  EXPECT_EQ(frame().status.state, ServoState::kPosture);
  const JointVector before = state_.command.position();
  frames(10);
  EXPECT_GT((state_.command.position() - before).norm(), 0.0);
}

TEST_F(GoalAge, RepeatsAtFiveHertzWithTheFramesTimeAreOftenEnough) {
  frame();
  machine_.observe(servo_goal(), state_);
  EXPECT_EQ(frames_at_5_hz(60).status.state, ServoState::kConverged);
}

TEST_F(GoalAge, TheGripperKeepsWhatItWasTold) {
  frame();
  Goal goal = posture_goal(start_);
  goal.gripper_opening = 0.01;
  machine_.observe(goal, state_);
  frames(2);
  sender_lives_ = false;
  const Output output = frames(40);
  EXPECT_EQ(output.status.state, ServoState::kStale);
  EXPECT_EQ(output.command->gripper_opening, 0.01);
}

TEST_F(GoalAge, AfterALongBlindTimeNothingOfTheFormerMotionGoesOn) {
  frame();
  machine_.observe(posture_goal(start_ + JointVector(0.6, -0.2, 0.1)), state_);
  frames(4);
  sender_lives_ = false;
  const JointVector before = state_.command.position();
  // No picture for 3 s, while the joints report.
  for (int i = 0; i < 90; ++i) {
    arm_.expose();
    for (const auto& sample : arm_.take_joint_states()) machine_.observe(sample, state_);
    arm_.finish_frame(std::nullopt);
  }
  EXPECT_EQ(frame().status.state, ServoState::kStale);
  EXPECT_EQ((state_.command.position() - before).norm(), 0.0);
}

TEST_F(GoalAge, AGoalOfTheFutureHeardBeforeTheFirstJointStateDoesNotWaitForItsHour) {
  Goal goal = posture_goal(start_ + JointVector(0.6, -0.2, 0.1));
  goal.utime += 2'000'000;
  sender_lives_ = false;
  machine_.observe(goal, state_);
  for (int i = 0; i < 120; ++i) {
    const Output output = frame();
    EXPECT_NE(output.status.state, ServoState::kPosture);
    EXPECT_NEAR((output.command->position - start_).norm(), 0.0, 1e-9);
  }
  EXPECT_EQ(frame().status.reason, "the goal heard before the first JOINT_STATE is of another time: it was dropped");
}

}  // namespace
}  // namespace markservo::visual_servo::test
