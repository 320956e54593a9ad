// The states of the servo and what may move the arm.

#include <cmath>
#include <limits>

#include "tests/unit/visual-servo/rig.hpp"

namespace markservo::visual_servo::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class ServoStates : public Rig {};

TEST_F(ServoStates, WithoutJointStatesThereIsNothingToHold) {
  const Output output = machine_.step(arm_.expose(), state_);
  EXPECT_FALSE(output.command);
  EXPECT_EQ(output.status.state, ServoState::kStale);
}

TEST_F(ServoStates, WithoutAGoalTheArmStaysWhereItIs) {
  frames(2);
  const Output output = frame();
  ASSERT_TRUE(output.command);
  EXPECT_EQ(output.status.state, ServoState::kHold);
  EXPECT_EQ(output.command->position, start_);
  EXPECT_TRUE(output.status.settled);
}

TEST_F(ServoStates, ServesTheGoalAndEchoesItsIdentity) {
  frame();
  machine_.observe(servo_goal(), state_);
  const Output output = frames_until(ServoState::kConverged);
  EXPECT_EQ(output.status.goal_session, 5);
  EXPECT_EQ(output.status.goal_id, 1);
  EXPECT_TRUE(output.status.settled);
  EXPECT_LT(output.status.error.norm(), 0.001);
  EXPECT_LT((arm_.grip_point() - goal_point_).norm(), 0.001);
  EXPECT_GT(output.status.covariance.trace(), 0.0);
}

TEST_F(ServoStates, APictureThatIsTooOldMovesNothing) {
  machine_.observe(servo_goal(), state_);
  const Output before = frames(6);
  PoseSample old = arm_.expose();
  for (auto sample : arm_.take_joint_states()) {
    sample.utime += 250'000;
    machine_.observe(sample, state_);
  }
  const Output output = machine_.step(old, state_);
  EXPECT_EQ(output.status.state, ServoState::kStale);
  EXPECT_EQ(output.command->position, before.command->position);
  EXPECT_NE(output.status.reason.find("TARGET_POSE is 0.25 s older"), std::string::npos);
}

TEST_F(ServoStates, WithoutFreshJointStatesNothingMoves) {
  machine_.observe(servo_goal(), state_);
  const Output before = frames(6);
  PoseSample pose = arm_.expose();
  pose.utime += 350'000;
  const Output output = machine_.step(pose, state_);
  EXPECT_EQ(output.status.state, ServoState::kStale);
  EXPECT_EQ(output.command->position, before.command->position);
  EXPECT_NE(output.status.reason.find("s newer than JOINT_STATE; allowed: 0.30 s"), std::string::npos);
}

TEST_F(ServoStates, TheSamePictureTwiceMovesOnce) {
  machine_.observe(servo_goal(), state_);
  const Output before = frames(6);
  const Output output = machine_.step(last_pose_, state_);
  EXPECT_EQ(output.status.state, ServoState::kStale);
  EXPECT_EQ(output.command->position, before.command->position);
}

TEST_F(ServoStates, APictureWithAnImpossibleTimeDoesNotOutdateThoseThatFollow) {
  machine_.observe(servo_goal(), state_);
  frames(6);
  PoseSample wrong = last_pose_;
  wrong.utime += 3'600'000'000;
  EXPECT_EQ(machine_.step(wrong, state_).status.state, ServoState::kStale);
  EXPECT_EQ(frame().status.state, ServoState::kServo);
  wrong.frame_session = 77;
  EXPECT_EQ(machine_.step(wrong, state_).status.state, ServoState::kStale);
  EXPECT_EQ(frame().status.state, ServoState::kServo);
  frames_until(ServoState::kConverged);
}

TEST_F(ServoStates, ALostMarkBringsTheArmToRestAndServoingGoesOnWhenItIsBack) {
  machine_.observe(servo_goal(), state_);
  const Output moving = frames(8);
  arm_.hide_hand = true;
  Output output = frame();
  EXPECT_EQ(output.status.state, ServoState::kLost);
  EXPECT_EQ(output.status.reason, "mark hand: hidden");
  const double first = (output.command->position - moving.command->position).norm();
  frames(3);
  const JointVector rest = frame().command->position;
  EXPECT_GT(first, 0.0);
  EXPECT_EQ(frame().command->position, rest);  // 6 frames, 0.2 s after the loss
  const double y_at_rest = arm_.grip_point().y();
  EXPECT_LT(y_at_rest, goal_point_.y());
  output = frames(10);
  EXPECT_EQ(output.command->position, rest);
  EXPECT_EQ(arm_.grip_point().y(), y_at_rest);
  arm_.hide_hand = false;
  frames_until(ServoState::kConverged);
}

TEST_F(ServoStates, ALostTargetIsToldByName) {
  machine_.observe(servo_goal(), state_);
  frames(3);
  arm_.hide_target = true;
  EXPECT_EQ(frame().status.reason, "mark red_book: hidden");
}

TEST_F(ServoStates, AMarkFarFromWhereTheJointsSayIsNotTheHand) {
  machine_.observe(servo_goal(), state_);
  frames(2);
  PoseSample pose = arm_.expose();
  for (const auto& sample : arm_.take_joint_states()) machine_.observe(sample, state_);
  pose.marks[0].p_C.x() += 0.06;
  const Output output = machine_.step(pose, state_);
  EXPECT_EQ(output.status.state, ServoState::kLost);
  EXPECT_NE(output.status.reason.find("from where the joints say it is"), std::string::npos);
}

TEST_F(ServoStates, APositionThatIsNotFiniteCountsAsLost) {
  machine_.observe(servo_goal(), state_);
  frames(2);
  PoseSample pose = arm_.expose();
  for (const auto& sample : arm_.take_joint_states()) machine_.observe(sample, state_);
  pose.marks[0].p_C.x() = kNan;
  const Output output = machine_.step(pose, state_);
  EXPECT_EQ(output.status.state, ServoState::kLost);
  EXPECT_TRUE(output.command->position.allFinite());
}

TEST_F(ServoStates, JointStatesThatAreNotFiniteAreRefused) {
  JointSample sample;
  sample.position = {0.0, kNan, 0.0};
  EXPECT_FALSE(machine_.observe(sample, state_));
  EXPECT_TRUE(state_.joints.empty());
}

TEST_F(ServoStates, AGoalThatIsNotFiniteReplacesTheOldOneAndMovesNothing) {
  machine_.observe(servo_goal(), state_);
  frames_until(ServoState::kConverged);
  Goal goal = servo_goal(2);
  goal.p_TG_C.y() = kNan;
  machine_.observe(goal, state_);
  const JointVector before = state_.command.position();
  const Output output = frames(5);
  EXPECT_EQ(output.status.state, ServoState::kUnreachable);
  EXPECT_EQ(output.status.goal_id, 2);
  EXPECT_EQ(output.command->position, before);
}

TEST_F(ServoStates, StopEndsTheGoalForGood) {
  frame();
  machine_.observe(servo_goal(), state_);
  frames(6);
  arm_.stopped = true;
  machine_.observe_stop(true, "button", state_);
  Output output = frames(10);
  EXPECT_EQ(output.status.state, ServoState::kStopped);
  EXPECT_EQ(output.status.reason, "button");
  const JointVector stopped_at = output.command->position;
  stop(false);
  machine_.observe(servo_goal(), state_);  // the repeat of the old goal
  output = frames(10);
  EXPECT_EQ(output.status.state, ServoState::kHold);
  EXPECT_EQ(output.command->position, stopped_at);
  machine_.observe(servo_goal(2), state_);
  frames_until(ServoState::kConverged);
}

TEST_F(ServoStates, AGoalFirstHeardWhileStoppedNeverMoves) {
  machine_.observe_stop(true, "", state_);
  machine_.observe(servo_goal(7), state_);
  frames(3);
  machine_.observe_stop(false, "", state_);
  machine_.observe(servo_goal(7), state_);
  EXPECT_EQ(frames(3).status.state, ServoState::kHold);
}

TEST_F(ServoStates, BeforeTheArmsFirstStopStateNothingMovesAndTheGoalWaits) {
  state_ = State();
  machine_.observe(servo_goal(), state_);
  const Output output = frames(5);
  EXPECT_EQ(output.status.state, ServoState::kStopped);
  EXPECT_EQ(output.command->position, start_);
  machine_.observe_stop(false, "", state_);
  frames_until(ServoState::kConverged);
}

TEST_F(ServoStates, HoldSlowsDownAndStays) {
  machine_.observe(servo_goal(), state_);
  frames(8);
  Goal hold = servo_goal(2);
  hold.kind = GoalKind::kHold;
  machine_.observe(hold, state_);
  frames(6);
  const JointVector rest = state_.command.position();
  const Output output = frames(10);
  EXPECT_EQ(output.status.state, ServoState::kHold);
  EXPECT_TRUE(output.status.settled);
  EXPECT_EQ(output.command->position, rest);
}

TEST_F(ServoStates, AnOlderGoalOfTheSameSessionIsPassedOver) {
  machine_.observe(servo_goal(4), state_);
  EXPECT_EQ(machine_.observe(servo_goal(3), state_), motion::GoalHeard::kEnded);
  EXPECT_EQ(state_.followed.goal()->id, 4);
}

TEST_F(ServoStates, ATargetThatIsMovedAwayIsFollowed) {
  machine_.observe(servo_goal(), state_);
  frames_until(ServoState::kConverged);
  const Eigen::Vector3d moved(0.02, -0.02, 0.0);
  arm_.move_target(p_CT_ + moved);
  frames_until(ServoState::kServo, 10);
  frames_until(ServoState::kConverged);
  EXPECT_LT((arm_.grip_point() - goal_point_ - moved).norm(), 0.001);
}

TEST_F(ServoStates, AGoalThatIsMetAlreadyMovesNothing) {
  machine_.observe(servo_goal(1), state_);
  frames_until(ServoState::kConverged);
  const JointVector before = state_.command.position();
  Goal again = servo_goal(2);
  again.gripper_opening = 0.0;
  machine_.observe(again, state_);
  const Output output = frames_until(ServoState::kConverged, 10);
  EXPECT_EQ(output.command->position, before);
  EXPECT_EQ(output.command->gripper_opening, 0.0);
}

TEST_F(ServoStates, ARestartedServoGoesOnWithoutAJump) {
  machine_.observe(servo_goal(), state_);
  frames(8);
  state_ = State();
  Output output = frame();
  const JointVector there = state_.joints.newest().position;
  EXPECT_EQ(output.command->position, there);
  machine_.observe_stop(false, "", state_);
  machine_.observe(servo_goal(), state_);
  JointVector before = output.command->position;
  output = frame();
  EXPECT_LT((output.command->position - before).cwiseAbs().maxCoeff(), 0.04);
  frames_until(ServoState::kConverged);
}

TEST_F(ServoStates, AnArmThatWasPutElsewhereIsNotPulledBack) {
  frames(5);
  const JointVector elsewhere = start_ + JointVector(0.8, 0.3, -0.2);
  arm_.place(elsewhere, p_CT_);
  frame();
  EXPECT_EQ(frame().command->position, elsewhere);
}

TEST_F(ServoStates, AStopAndResetBetweenTwoPicturesBeginFromWhereTheArmIs) {
  frames(5);
  const JointVector near_by = start_ + JointVector(0.05, 0.05, -0.05);  // less than a leap
  arm_.place(near_by, p_CT_);
  machine_.observe_stop(true, "", state_);
  machine_.observe_stop(false, "", state_);
  EXPECT_EQ(frame().command->position, near_by);
}

TEST(JointHistory, AfterAGapTheArmMayHaveBeenMovedUnseen) {
  const JointVector speed = JointVector::Constant(5.0);
  JointHistory history;
  JointSample sample;
  sample.utime = 1'000'000;
  EXPECT_FALSE(history.add(sample, speed));
  sample.utime += 10'000;
  EXPECT_FALSE(history.add(sample, speed));
  sample.utime += 1'000'000;
  EXPECT_TRUE(history.add(sample, speed));
}

TEST_F(ServoStates, AnArmThatDoesNotFollowIsNotLeftBehind) {
  machine_.observe(posture_goal({1.2, 1.0, -1.0}), state_);
  Output output;
  for (int i = 0; i < 40; ++i) {
    const PoseSample pose = arm_.expose();
    for (const auto& sample : arm_.take_joint_states()) machine_.observe(sample, state_);
    output = machine_.step(pose, state_);
    arm_.finish_frame(std::nullopt);
    EXPECT_LT((output.command->position - start_).cwiseAbs().maxCoeff(), 0.71);
  }
}

TEST_F(ServoStates, TheGripperStaysWithinItsLimits) {
  frame();
  Goal goal = servo_goal();
  goal.gripper_opening = 0.2;
  goal.gripper_force = 100.0;
  machine_.observe(goal, state_);
  const Output output = frame();
  EXPECT_EQ(output.command->gripper_opening, robot_.arm->gripper.opening_max);
  EXPECT_EQ(output.command->gripper_force, robot_.arm->gripper.force_max);
}

TEST_F(ServoStates, ARestartWithAnObjectInTheHandGoesOnPressing) {
  const PoseSample pose = arm_.expose();
  JointSample sample;
  sample.utime = pose.utime;
  sample.position = start_;
  sample.gripper_opening = 0.025;
  sample.contact = true;
  machine_.observe(sample, state_);
  EXPECT_EQ(machine_.step(pose, state_).command->gripper_opening, 0.0);
}

}  // namespace
}  // namespace markservo::visual_servo::test
