#include <gtest/gtest.h>

#include "services/simulator/arm/delayed_commands.hpp"
#include "services/simulator/cameras/frame_schedule.hpp"
#include "services/simulator/time/lockstep_barrier.hpp"

namespace markservo::simulator {
namespace {

TEST(LockstepBarrier, WaitsForEveryChannel) {
  LockstepBarrier barrier({"JOINT_COMMAND", "TASK_STATE"});
  barrier.expect(7, 1);
  EXPECT_EQ(barrier.missing(), "JOINT_COMMAND, TASK_STATE");
  barrier.observe("TASK_STATE", 7, 1);
  EXPECT_EQ(barrier.missing(), "JOINT_COMMAND");
  barrier.observe("JOINT_COMMAND", 7, 1);
  EXPECT_TRUE(barrier.complete());
}

TEST(LockstepBarrier, CountsAnswersToTheExpectedFrameOnly) {
  LockstepBarrier barrier({"JOINT_COMMAND"});
  barrier.expect(7, 2);
  barrier.observe("JOINT_COMMAND", 7, 1);
  barrier.observe("JOINT_COMMAND", 8, 2);
  EXPECT_FALSE(barrier.complete());
}

TEST(LockstepBarrier, EveryFrameIsAnsweredAnew) {
  LockstepBarrier barrier({"JOINT_COMMAND"});
  barrier.expect(7, 1);
  barrier.observe("JOINT_COMMAND", 7, 1);
  barrier.expect(7, 2);
  EXPECT_FALSE(barrier.complete());
}

TEST(LockstepBarrier, AnAnswerToAnySendingOfAnExposureCounts) {
  LockstepBarrier barrier({"JOINT_COMMAND", "TASK_STATE"});
  barrier.expect(7, 2);
  barrier.expect_also(3);
  barrier.observe("JOINT_COMMAND", 7, 2);
  barrier.observe("TASK_STATE", 7, 3);
  EXPECT_TRUE(barrier.complete());
}

TEST(FrameSchedule, ThirtyFramesTakeASecond) {
  FrameSchedule schedule(30.0, 0.002, 100);
  EXPECT_EQ(schedule.next(), 100);
  schedule.advance();
  EXPECT_EQ(schedule.next(), 117);
  schedule.advance();
  EXPECT_EQ(schedule.next(), 133);
  for (int frame = 2; frame < 30; ++frame) schedule.advance();
  EXPECT_EQ(schedule.next(), 600);
}

TEST(DelayedCommands, ComeWhenTheirTimeHasComeAndOnlyOnce) {
  DelayedCommands delayed;
  ArmCommand command;
  command.gripper_opening = 0.01;
  delayed.add(5, command);
  EXPECT_FALSE(delayed.take(4).has_value());
  ASSERT_TRUE(delayed.take(5).has_value());
  EXPECT_FALSE(delayed.take(6).has_value());
}

TEST(DelayedCommands, TheNewestOfThoseDueCounts) {
  DelayedCommands delayed;
  ArmCommand command;
  command.gripper_opening = 0.01;
  delayed.add(5, command);
  command.gripper_opening = 0.02;
  delayed.add(6, command);
  EXPECT_EQ(delayed.take(6)->gripper_opening, 0.02);
}

}  // namespace
}  // namespace markservo::simulator
