// What cannot be done is refused with its reason, and postures are reached as asked.

#include <algorithm>
#include <cmath>
#include <tuple>

#include "tests/unit/visual-servo/rig.hpp"

namespace markservo::visual_servo::test {
namespace {

class ServoGoals : public Rig {
 protected:
  // The goal's refusal, with the arm at rest where it started.
  std::string refusal(Goal goal) {
    frame();
    goal.utime = state_.joints.newest().utime;
    machine_.observe(goal, state_);
    const Output output = frames(5);
    EXPECT_EQ(output.status.state, ServoState::kUnreachable);
    EXPECT_EQ(output.command->position, start_);
    return output.status.reason;
  }
};

TEST_F(ServoGoals, ATargetBeyondTheArmIsUnreachable) {
  Goal goal = servo_goal();
  goal.p_TG_C.y() += 0.2;
  EXPECT_NE(refusal(goal).find("the arm reaches 0.400 m"), std::string::npos);
}

TEST_F(ServoGoals, AJointBeyondItsLimitIsNamedWithItsValueAndLimits) {
  Goal goal = servo_goal();
  goal.p_TG_C = {-0.2, -0.25, -0.052};
  const std::string reason = refusal(goal);
  EXPECT_NE(reason.find("joint yaw would be at "), std::string::npos) << reason;
  EXPECT_NE(reason.find("allowed -89.5 to 89.5 deg"), std::string::npos) << reason;
}

TEST_F(ServoGoals, APostureBeyondALimitIsRefusedByName) {
  EXPECT_EQ(refusal(posture_goal({0.0, 170.0 * kDegree, -1.0})),
            "posture: joint shoulder at 170.0 deg, allowed -5.0 to 160.0 deg");
}

TEST_F(ServoGoals, APostureWithAnotherNumberOfJointsIsRefused) {
  Goal goal = posture_goal(start_);
  goal.position.pop_back();
  EXPECT_EQ(refusal(goal), "posture has 2 joints, the arm has 3");
}

TEST_F(ServoGoals, AnUnknownTargetIsRefusedWithThoseThatAreKnown) {
  Goal goal = servo_goal();
  goal.target = "hand";
  EXPECT_EQ(refusal(goal), "target 'hand' is not a target in robot.yaml, allowed: red_book, yellow_book, blue_book");
}

TEST_F(ServoGoals, AKnownTargetThatIsNotListedIsLost) {
  frame();
  Goal goal = servo_goal();
  goal.target = "blue_book";
  machine_.observe(goal, state_);
  const Output output = frame();
  EXPECT_EQ(output.status.state, ServoState::kLost);
  EXPECT_EQ(output.status.reason, "TARGET_POSE does not list mark blue_book");
}

TEST_F(ServoGoals, APostureIsReachedWithAllJointsEndingTogether) {
  frame();
  const JointVector goal = start_ + JointVector(0.6, -0.2, 0.1);
  machine_.observe(posture_goal(goal), state_);
  JointVector before = start_;
  for (int i = 0; i < 60; ++i) {
    const Output output = frame();
    EXPECT_EQ(output.status.state, ServoState::kPosture);
    const JointVector done = (output.command->position - start_).cwiseQuotient(goal - start_);
    EXPECT_NEAR(done[0], done[1], 1e-9);
    EXPECT_NEAR(done[0], done[2], 1e-9);
    EXPECT_LE((output.command->position - before).cwiseAbs().maxCoeff(), 1.5 / 30.0 + 1e-4);
    before = output.command->position;
    if (output.status.settled) break;
  }
  const Output output = frame();
  EXPECT_TRUE(output.status.settled);
  EXPECT_LT((state_.joints.newest().position - goal).norm(), 1e-9);
}

TEST_F(ServoGoals, AnArmThatRestsIsCommandedAtTheSlowestSpeed) {
  frame();
  machine_.observe(servo_goal(), state_);
  double fastest = 0.0;
  for (int i = 0; i < 60; ++i) fastest = std::max(fastest, frame().command->speed_limit.maxCoeff());
  EXPECT_GT(fastest, 0.9) << "the last step is made at once";
  EXPECT_EQ(frame().command->speed_limit, JointVector::Constant(0.2));
}

TEST_F(ServoGoals, TheGoalsSpeedLimitsTheGripPoint) {
  frame();
  Goal goal = servo_goal();
  goal.speed = 0.05;
  machine_.observe(goal, state_);
  Eigen::Vector3d before = arm_.grip_point();
  for (int i = 0; i < 40; ++i) {
    frame();
    EXPECT_LE((arm_.grip_point() - before).norm(), 0.05 / 30.0 * 1.1);
    before = arm_.grip_point();
  }
  frames_until(ServoState::kConverged, 120);
}

TEST_F(ServoGoals, TheWayByResolvedRateIsStraight) {
  frame();
  machine_.observe(servo_goal(), state_);
  for (int i = 0; i < 10; ++i) frame();
  EXPECT_LT(arm_.largest_sweep(goal_point_), 0.007);  // straight to the entry, which is 5 mm beside the goal
  frames_until(ServoState::kConverged);
  EXPECT_LT(arm_.deepest_y(), goal_point_.y() + 0.003);
}

// By the kind of deadband, and by how far a posture between two goals turns the yaw off where the arm began, rad:
// little crosses a servo's play in part, more leaves it on the one side or the other.
class ServosWithPlay : public Rig, public testing::WithParamInterface<std::tuple<simulator::DeadbandKind, double>> {
 protected:
  ServosWithPlay() {
    SimulatorSettings settings;
    settings.servos.deadband = std::get<0>(GetParam());
    settings.servos.deadband_rad = 0.3 * kDegree;
    settings.servos.backlash_rad = 0.6 * kDegree;
    settings.vision_sigma = 0.0;  // m: what is told wrongly is not noise
    arm_ = ArmSimulator(robot_, settings, 3);
    arm_.place(start_, p_CT_);
  }

  // m, how far from where it is the grip point is seen in the next frame, to which the arm has come by itself.
  double wrongly_seen() {
    const Eigen::Vector3d error = arm_.grip_point() - goal_point_;
    return (frame().status.error - error).norm();
  }
};

TEST_P(ServosWithPlay, TheGripPointIsSeenWhereItIsThoughAPostureTurnedTheJoints) {
  frame();
  machine_.observe(servo_goal(1), state_);
  frames_until(ServoState::kConverged, 200);
  EXPECT_LT(wrongly_seen(), 0.00015);
  machine_.observe(posture_goal(start_ + JointVector(std::get<1>(GetParam()), 0.0, 0.0), 2), state_);
  frames(60);
  frames(60);  // 2 s at rest
  machine_.observe(servo_goal(3), state_);
  EXPECT_LT(wrongly_seen(), 0.00015);
}

TEST_P(ServosWithPlay, TheGripPointIsSeenWhereItIsAfterARest) {
  frame();
  machine_.observe(servo_goal(1), state_);
  frames_until(ServoState::kConverged, 200);
  Goal hold = servo_goal(2);
  hold.kind = GoalKind::kHold;
  machine_.observe(hold, state_);
  frames(60);  // 2 s
  machine_.observe(servo_goal(3), state_);
  EXPECT_LT(wrongly_seen(), 0.00015);
}

INSTANTIATE_TEST_SUITE_P(Deadbands, ServosWithPlay,
                         testing::Combine(testing::Values(simulator::DeadbandKind::kStopsAtEdge,
                                                          simulator::DeadbandKind::kRunsHome),
                                          testing::Values(-0.2, 0.0, 0.2)));

}  // namespace
}  // namespace markservo::visual_servo::test
