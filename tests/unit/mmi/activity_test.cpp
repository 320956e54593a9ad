#include <gtest/gtest.h>

#include "services/mmi/troubles/robot_state.hpp"

namespace markservo::mmi {
namespace {

RobotState with_task(TaskPhase phase, const std::string& reason = "") {
  RobotState state;
  state.observe(TaskWord{0, phase, TaskResult::kNone, "red_book", reason});
  return state;
}

TEST(Activity, ServoingTellsTheTargetAndTheWayLeft) {
  RobotState state = with_task(TaskPhase::kServo, "servoing to the grip point");
  state.observe(ServoWord{0, ServoState::kServo, false, 0.0032, ""});
  EXPECT_EQ(state.activity(), "SERVO: red_book, 3.2 mm to go");
  state.observe(ServoWord{0, ServoState::kServo, false, 0.0, ""});
  EXPECT_EQ(state.activity(), "SERVO: red_book");
  state.observe(ServoWord{0, ServoState::kLost, false, 0.0, "mark red_book: seen by neither camera"});
  EXPECT_EQ(state.activity(), "SERVO: red_book, holds: mark red_book: seen by neither camera");
}

TEST(Activity, ADriveTellsTheWayLeftOrWhyItStands) {
  RobotState state = with_task(TaskPhase::kDrive, "folding the arm");
  EXPECT_EQ(state.activity(), "DRIVE: folding the arm");
  state.observe(BaseWord{0, BaseState::kDriving, 0.81, ""});
  EXPECT_EQ(state.activity(), "DRIVE: 0.8 m to go");
  state.observe(BaseWord{0, BaseState::kBlocked, 0.81, "sonar 3"});
  EXPECT_EQ(state.activity(), "DRIVE: stands, blocked: sonar 3");
}

TEST(Activity, AtRestItIsOneWordAndTheReason) {
  EXPECT_EQ(with_task(TaskPhase::kIdle).activity(), "idle");
  EXPECT_EQ(with_task(TaskPhase::kHoldLifted).activity(), "lifted: red_book");
  EXPECT_EQ(with_task(TaskPhase::kDone).activity(), "done: red_book");
  EXPECT_EQ(with_task(TaskPhase::kRefused, "out of reach").activity(), "REFUSED: red_book, out of reach");
  EXPECT_EQ(with_task(TaskPhase::kGoHome, "on the way home").activity(), "GO HOME: on the way home");
}

TEST(Activity, WithoutATaskManagerSaysSo) {
  RobotState state;
  EXPECT_EQ(state.activity(), "nothing is heard of a robot");
  state.observe(BaseWord{0, BaseState::kHold, 0.0, "no goal"});
  EXPECT_EQ(state.activity(), "no task is told of: task-manager is not heard");
  state.observe(BaseWord{0, BaseState::kDriving, 2.0, ""});
  EXPECT_EQ(state.activity(), "DRIVE: 2.0 m to go");
}

TEST(RobotState, APhaseIsSinceItsFirstMessage) {
  RobotState state;
  state.observe(TaskWord{10, TaskPhase::kLook, TaskResult::kNone, "red_book", ""});
  state.observe(TaskWord{20, TaskPhase::kServo, TaskResult::kNone, "red_book", "to the line"});
  state.observe(TaskWord{30, TaskPhase::kServo, TaskResult::kNone, "red_book", "to the grip point"});
  EXPECT_EQ(state.task_since_utime(), 20);
}

TEST(RobotState, ARecordingThatGoesOnCountsBeforeOneThatHasEnded) {
  RobotState state;
  state.observe(RecorderWord{1, "a", "host", true, 0, 0, 1, ""});
  state.observe(RecorderWord{2, "b", "host", false, 0, 0, 1, "the disk is full"});
  EXPECT_EQ(state.recorder()->folder, "a");
  state.observe(RecorderWord{3, "a", "host", false, 0, 0, 1, ""});
  EXPECT_FALSE(state.recorder()->recording);
}

}  // namespace
}  // namespace markservo::mmi
