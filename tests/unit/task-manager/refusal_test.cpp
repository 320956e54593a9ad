// What cannot be taken is refused with the reason, and the arm never moves.

#include <gtest/gtest.h>

#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

void expect_refused(FakeRobot& robot, const std::string& beginning) {
  ASSERT_TRUE(robot.run_until(Phase::kRefused, 10.0)) << name_of(robot.last().phase) << ": " << robot.last().reason;
  EXPECT_EQ(robot.last().reason.rfind(beginning, 0), 0u) << robot.last().reason;
  EXPECT_EQ(robot.last().result, Result::kRefused);
  robot.run_for(3.0);
  EXPECT_EQ(robot.last().phase, Phase::kRefused);
  EXPECT_EQ(robot.way_of_joints(), 0.0);
}

TEST(Refusal, ATargetOutOfReachIsUnreachable) {
  FakeRobot robot;
  robot.p_CT.y() = 0.40;
  robot.send(CommandKind::kStart, "red_book");
  expect_refused(robot, "unreachable: beyond the arm's reach");
}

TEST(Refusal, AMarkNextToAnImageBorderIsOutOfView) {
  FakeRobot robot;
  robot.p_CT << 0.0875, 0.25, 0.032;  // located, but within 8 px of the left image's border
  robot.send(CommandKind::kStart, "red_book");
  expect_refused(robot, "out_of_view: the mark of red_book is not wholly inside both images");
}

TEST(Refusal, AnUnseenTargetIsOutOfViewAndSaysWhatEachCameraSees) {
  FakeRobot robot;
  robot.target_sight = Sight::kUnseen;
  robot.send(CommandKind::kStart, "red_book");
  expect_refused(robot, "out_of_view: the mark of red_book is seen by neither camera");
  robot.target_sight = Sight::kSeenByOne;
  robot.send(CommandKind::kStart, "red_book");
  robot.frame();
  expect_refused(robot, "out_of_view: the mark of red_book is seen by one camera only");
}

TEST(Refusal, AnUnseenTargetThatIsExpectedOutOfReachIsUnreachable) {
  const robot::RobotDescription description = default_robot();
  Procedure procedure(description, Parameters());
  State state;
  Input input;
  input.arm = ArmReport{7, description.arm->home, 0.05};
  input.stop.known = true;
  input.marks = {{"red_book", Sight::kUnseen, Eigen::Vector3d::Zero()}};
  Command start;
  start.session = 1;
  start.id = 1;
  start.kind = CommandKind::kStart;
  start.target = "red_book";
  start.p_CT_expected = Eigen::Vector3d(0.1, 0.5, 0.032);
  input.commands = {start};
  Output output;
  for (int i = 1; i < 60; ++i) {
    input.utime = input.pose_utime = i * 33'333;
    output = procedure.step(input, state);
    input.commands.clear();
  }
  EXPECT_EQ(output.phase, Phase::kRefused);
  EXPECT_EQ(output.reason.rfind("unreachable: beyond the arm's reach: 0.", 0), 0U) << output.reason;
}

TEST(Refusal, NamesTheTargetsThatThereAre) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "green_book");
  expect_refused(robot, "unknown target 'green_book'; the robot's description has: red_book, yellow_book, blue_book");
}

TEST(Refusal, TheHandIsNoTarget) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "hand");
  expect_refused(robot, "unknown target 'hand'");
}

TEST(Refusal, ATargetWithoutGripCannotBeTaken) {
  robot::RobotDescription description = default_robot();
  for (auto& mark : description.marks) {
    if (mark.name == "yellow_book") mark.grip.reset();
  }
  FakeRobot robot(description);
  robot.send(CommandKind::kStart, "yellow_book");
  expect_refused(robot, "the description of yellow_book has no section 'grip'");
}

TEST(Refusal, ARobotWithoutArmTakesNothing) {
  robot::RobotDescription description = default_robot();
  description.arm.reset();
  FakeRobot robot(description);
  robot.arm_answers = false;
  robot.send(CommandKind::kStart, "red_book");
  expect_refused(robot, "the robot has no arm");
  EXPECT_EQ(robot.goals_sent(), 0);
  robot.send(CommandKind::kHome);
  EXPECT_TRUE(robot.run_until(Phase::kStopped, 1.0));
}

TEST(Refusal, ALatchedStopMustBeResetFirst) {
  FakeRobot robot;
  robot.stop = {true, true, "arm: started"};
  robot.send(CommandKind::kStart, "red_book");
  expect_refused(robot, "stop is latched: reset it first");
}

TEST(Refusal, AStopThatIsLearntOnlyAfterStartStillRefuses) {
  FakeRobot robot;
  robot.stop.known = false;
  robot.send(CommandKind::kStart, "red_book");
  robot.run_for(0.3);
  EXPECT_EQ(robot.last().phase, Phase::kLook);
  robot.stop = {true, true, "arm: started"};
  expect_refused(robot, "stop is latched: reset it first");
}

TEST(Refusal, AnArmThatDoesNotAnswerTakesNothing) {
  FakeRobot robot;
  robot.arm_answers = false;
  robot.send(CommandKind::kStart, "red_book");
  expect_refused(robot, "the arm does not answer");
}

TEST(Refusal, ABookThatCannotBeCarriedOutOfItsRowIsNotTouched) {
  FakeRobot robot;
  robot.p_CT.y() = 0.20;  // the column is too near to draw it out
  robot.send(CommandKind::kStart, "red_book", true);
  expect_refused(robot, "unreachable: it could not be carried: ");
}

}  // namespace
}  // namespace markservo::task_manager
