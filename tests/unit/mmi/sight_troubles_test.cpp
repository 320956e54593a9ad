// What is a trouble of cameras and marks, and what is none.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mmi/healthy_robot.hpp"

namespace markservo::mmi {
namespace {

using ::testing::HasSubstr;

TEST(MarkTroubles, SomeFramesWithoutTheMarkAreNone) {
  HealthyRobot robot;
  robot.pass(2.0);
  MarkStatus& status = robot.marks.marks[1].status;
  for (int blink = 0; blink < 10; ++blink) {
    status = MarkStatus::kUnseen;
    EXPECT_TRUE(robot.pass(0.3).empty());
    status = MarkStatus::kLocated;
    EXPECT_TRUE(robot.pass(0.1).empty());
  }
}

TEST(MarkTroubles, OneFrameWithTheMarkDoesNotInterruptATrouble) {
  HealthyRobot robot;
  robot.pass(2.0);
  robot.marks.marks[1].status = MarkStatus::kUnseen;
  const auto begun = of_code(robot.pass(2.0), TroubleCode::kMarkUnseen);
  robot.marks.marks[1].status = MarkStatus::kLocated;
  EXPECT_TRUE(of_code(robot.pass(0.1), TroubleCode::kMarkUnseen));
  robot.marks.marks[1].status = MarkStatus::kUnseen;
  for (int tick = 0; tick < 20; ++tick) EXPECT_EQ(of_code(robot.pass(0.1), TroubleCode::kMarkUnseen), begun);
}

TEST(MarkTroubles, AHandOutOfViewIsNoneWhileTheTaskLooks) {
  HealthyRobot robot;
  robot.task.phase = TaskPhase::kLook;
  robot.marks.marks[0].status = MarkStatus::kUnseen;
  EXPECT_TRUE(robot.pass(5.0).empty());
  robot.marks.marks[1].status = MarkStatus::kUnseen;
  EXPECT_TRUE(of_code(robot.pass(1.0), TroubleCode::kMarkUnseen));
}

TEST(MarkTroubles, TheHandIsNeededInAnApproachOnceItRestsBeforeTheTarget) {
  HealthyRobot robot;
  robot.task.phase = TaskPhase::kApproach;
  robot.servo = {0, ServoState::kPosture, false, 0.0, ""};
  robot.marks.marks[0].status = MarkStatus::kUnseen;
  EXPECT_TRUE(robot.pass(5.0).empty());
  robot.servo.settled = true;
  EXPECT_EQ(of_code(robot.pass(1.0), TroubleCode::kHandUnseen)->subject, "hand");
}

TEST(MarkTroubles, NoMarkIsNeededWithoutATaskOrOnADrive) {
  for (const TaskPhase phase : {TaskPhase::kIdle, TaskPhase::kDrive, TaskPhase::kCarry, TaskPhase::kHoldLifted}) {
    HealthyRobot robot;
    robot.task.phase = phase;
    for (MarkWord& mark : robot.marks.marks) mark.status = MarkStatus::kUnseen;
    EXPECT_TRUE(robot.pass(3.0).empty()) << name_of(phase);
  }
}

TEST(MarkTroubles, ATargetThatNobodyLooksForIsUnseen) {
  HealthyRobot robot;
  robot.task.target = "blue_book";
  const auto trouble = of_code(robot.pass(1.0), TroubleCode::kMarkUnseen);
  ASSERT_TRUE(trouble);
  EXPECT_EQ(trouble->subject, "blue_book");
  EXPECT_THAT(trouble->text, HasSubstr("not looked for"));
}

TEST(MarkTroubles, WithoutPicturesNothingIsSaidOfMarks) {
  HealthyRobot robot;
  robot.marks.marks[1].status = MarkStatus::kUnseen;
  robot.pass(2.0);
  robot.silent = {"STEREO_FRAME", "TARGET_POSE", "SERVO_STATUS", "TASK_STATE"};
  const std::vector<Trouble> troubles = robot.pass(5.0);
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_EQ(troubles[0].code, TroubleCode::kCameraSilent);
}

TEST(MarkTroubles, AnotherThingThanTheHandIsSaidInTheServosWords) {
  HealthyRobot robot;
  robot.servo = {0, ServoState::kLost, false, 0.0, "mark hand: 0.100 m from where the joints say it is"};
  EXPECT_THAT(of_code(robot.pass(1.0), TroubleCode::kHandUnseen)->text, HasSubstr("0.100 m"));
}

TEST(CameraTroubles, AStackThatStartsWaitsAMomentForItsFirstPicture) {
  HealthyRobot robot;
  robot.silent = {"STEREO_FRAME"};
  robot.services[0].state = "waiting";
  robot.services[0].reason = "STEREO_FRAME: not heard yet";
  EXPECT_FALSE(is_ever_told(robot, TroubleCode::kCameraSilent, 3.0));
  EXPECT_THAT(of_code(robot.pass(3.0), TroubleCode::kCameraSilent)->text, HasSubstr("no picture has come yet"));
}

TEST(CameraTroubles, TheCamerasServiceSaysWhy) {
  HealthyRobot robot;
  robot.services.push_back(HealthyRobot::service("stereo-camera", 14));
  robot.services.back().state = "stale";
  robot.services.back().reason = "left camera: no such device";
  robot.pass(3.0);
  robot.silent = {"STEREO_FRAME"};
  const auto trouble = of_code(robot.pass(4.0), TroubleCode::kCameraSilent);
  ASSERT_TRUE(trouble);
  EXPECT_THAT(trouble->text, HasSubstr("left camera: no such device"));
}

TEST(CameraTroubles, WherePicturesAreNotHeardHereTheirReaderCounts) {
  HealthyRobot robot;
  robot.silent = {"STEREO_FRAME"};
  EXPECT_TRUE(robot.pass(10.0).empty());
  robot.services[0].state = "stale";
  robot.services[0].reason = "STEREO_FRAME: not heard for more than 1 s";
  EXPECT_THAT(of_code(robot.pass(2.0), TroubleCode::kCameraSilent)->text,
              HasSubstr("mark-detector gets no picture any more"));
}

}  // namespace
}  // namespace markservo::mmi
