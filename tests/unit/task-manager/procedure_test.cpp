// The way through figure 11, told by phases, the goals sent, and what becomes of the book.

#include "services/task-manager/procedure.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "common/robot/arm_kinematics.hpp"
#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

TEST(Procedure, LiftsTheBookAndHoldsItThere) {
  FakeRobot robot;
  robot.run_for(0.5);
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted)) << name_of(robot.last().phase) << robot.last().reason;
  EXPECT_EQ(robot.phases(),
            (std::vector<Phase>{Phase::kIdle, Phase::kLook, Phase::kApproach, Phase::kServo, Phase::kGrip, Phase::kLift,
                                Phase::kVerify, Phase::kLiftOn, Phase::kHoldLifted}));
  EXPECT_EQ(robot.last().result, Result::kLifted);
  EXPECT_EQ(robot.last().attempt, 1);
  EXPECT_EQ(robot.trespass(), "");
  robot.run_for(20.0);
  EXPECT_EQ(robot.last().phase, Phase::kHoldLifted);
  EXPECT_TRUE(robot.holds_book());
  EXPECT_GT(robot.lifted(), 0.020);
  EXPECT_LT(robot.goal().opening, 0.025);
}

TEST(Procedure, LiftsFromEveryDepthThatCanBeTaken) {
  for (const double y : {0.20, 0.225, 0.25, 0.275, 0.30}) {
    FakeRobot robot;
    robot.p_CT.y() = y;
    robot.send(CommandKind::kStart, "red_book");
    EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << "y " << y << ": " << robot.last().reason;
    EXPECT_GT(robot.lifted(), 0.020) << "y " << y;
    EXPECT_EQ(robot.trespass(), "") << "y " << y;
  }
}

TEST(Procedure, BringsAHandThatIsUnseenBeforeTheShelfInAlongTheLineOfApproach) {
  FakeRobot robot;
  robot.p_CT.x() = -0.0175;  // in view from 1.25 cm before the grip point only
  robot.send(CommandKind::kStart, "red_book");
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
  EXPECT_EQ(robot.trespass(), "");
}

TEST(Procedure, CarriesTheBookToTheSideAndGoesHome) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book", true);
  ASSERT_TRUE(robot.run_until(Phase::kRelease)) << robot.last().reason;
  EXPECT_EQ(robot.last().result, Result::kNone);
  ASSERT_TRUE(robot.run_until(Phase::kDone)) << robot.last().reason;
  EXPECT_EQ(robot.last().result, Result::kLifted);
  EXPECT_FALSE(robot.holds_book());
  EXPECT_LT(robot.p_CT.x(), -0.11);           // on the side table
  EXPECT_NEAR(robot.p_CT.z(), 0.032, 0.004);  // at its top
  EXPECT_LT((robot.q() - default_robot().arm->home).norm(), 1e-6);
}

TEST(Procedure, TriesOnceMoreWhenTheBookDoesNotComeAlong) {
  FakeRobot robot;
  robot.slips = 1;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kRelease)) << robot.last().reason;
  EXPECT_NE(robot.last().reason.find("the object did not come along"), std::string::npos) << robot.last().reason;
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
  EXPECT_EQ(robot.last().attempt, 2);
  EXPECT_EQ(robot.last().result, Result::kLifted);
  EXPECT_EQ(robot.trespass(), "");
}

TEST(Procedure, FailsAfterTwoGripsThatDidNotHold) {
  FakeRobot robot;
  robot.slips = 2;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kFailed)) << name_of(robot.last().phase);
  EXPECT_EQ(robot.last().attempt, 2);
  EXPECT_EQ(robot.last().result, Result::kFailed);
  EXPECT_EQ(robot.last().reason.rfind("the object did not come along: ", 0), 0u) << robot.last().reason;
  EXPECT_LT(robot.grip_point().y() + 0.015, robot.p_CT.y()) << "the hand has left the books";
  EXPECT_EQ(robot.trespass(), "");
}

TEST(Procedure, WaitsForALostMarkAndGoesOn) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.target_sight = Sight::kUnseen;
  robot.run_for(2.0);
  EXPECT_EQ(robot.last().phase, Phase::kServo);
  robot.target_sight = Sight::kLocated;
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
}

TEST(Procedure, BacksOffAndFailsWhenAMarkStaysLost) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.run_for(0.3);
  robot.target_sight = Sight::kSeenByOne;
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 20.0));
  EXPECT_EQ(robot.last().reason, "lost from sight: the mark of red_book is seen by one camera only");
  EXPECT_LT(robot.grip_point().y() + 0.015, robot.p_CT.y());
  EXPECT_EQ(robot.goal().kind, GoalKind::kHold);
}

TEST(Procedure, FailsWhenTheHandsMarkIsNotSeen) {
  FakeRobot robot;
  robot.hand_sight = Sight::kUnseen;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 20.0));
  EXPECT_EQ(robot.last().reason, "the hand's mark is not seen: the mark of hand is seen by neither camera");
}

TEST(Procedure, FailsWithVisualServosReasonWhenServoingCannotReach) {
  FakeRobot robot;
  robot.unreachable = "shoulder limit";
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 20.0));
  EXPECT_NE(robot.last().reason.find("shoulder limit"), std::string::npos) << robot.last().reason;
}

TEST(Procedure, FailsWhenInputStaysStale) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kServo));
  robot.stale = true;
  robot.run_for(2.0);
  EXPECT_EQ(robot.last().phase, Phase::kServo) << "a restarted service comes back within that";
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 10.0));
  EXPECT_NE(robot.last().reason.find("TARGET_POSE is 1.0 s old"), std::string::npos) << robot.last().reason;
}

TEST(Procedure, FailsWhenVisualServoDoesNotAnswerItsGoals) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kApproach));
  robot.follows_goals = false;
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 20.0));
  EXPECT_EQ(robot.last().reason, "visual-servo does not answer the goal");
}

TEST(Procedure, AGoalInItsNameUnderAHigherIdEndsTheTaskAndLocksNothing) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kApproach));
  robot.forged_goal_id = robot.goal().id + 1000;
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 20.0));
  robot.run_for(1.0);
  EXPECT_GT(robot.goal().id, robot.forged_goal_id);
  robot.send(CommandKind::kStart, "red_book");
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted));
}

TEST(Procedure, AReportOfAGoalThatNobodyCanHaveSentLeadsItNowhere) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kApproach));
  robot.forged_goal_id = std::numeric_limits<std::int64_t>::max();
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 20.0));
  robot.run_for(3.0);
  EXPECT_GT(robot.goal().id, 0);
  EXPECT_LT(robot.goal().id, 100);
  robot.forged_goal_id = 0;
  robot.send(CommandKind::kStart, "red_book");
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted));
}

TEST(Procedure, RepeatsAGoalFiveTimesASecondUnderTheSameId) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted));
  const std::int64_t id = robot.goal().id;
  const int before = robot.goals_sent();
  robot.run_for(2.0);
  EXPECT_EQ(robot.goal().id, id);
  EXPECT_NEAR(robot.goals_sent() - before, 9, 1);  // each 7th of 30 frames a second
}

TEST(Procedure, StepsAlikeFromAlikeInput) {
  FakeRobot one;
  FakeRobot other;
  one.send(CommandKind::kStart, "red_book");
  other.send(CommandKind::kStart, "red_book");
  for (int i = 0; i < 900; ++i) {
    one.frame();
    other.frame();
    ASSERT_EQ(one.last().phase, other.last().phase);
    ASSERT_EQ(one.goal().id, other.goal().id);
    ASSERT_EQ(one.goal().q, other.goal().q);
  }
}

}  // namespace
}  // namespace markservo::task_manager
