#include "common/task/dialogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace markservo::task {
namespace {

using ::testing::HasSubstr;

StopReport arm(bool latched, bool answers_us = false, const std::string& reason = {}) {
  return {"arm", latched, answers_us, reason};
}

TaskReport task(Phase phase, Answers answers = Answers::kUs, const std::string& reason = {}, double time = 100.0) {
  return {time, answers, phase, 1, "red_book", reason};
}

// A START or HOME that was sent at time 0: devices are released, no task is under way.
Dialogue sent(Action action) {
  Dialogue dialogue(action, {"arm"});
  dialogue.observe(arm(false));
  dialogue.observe(task(Phase::kIdle, Answers::kNobody), 0.0);
  EXPECT_TRUE(dialogue.step(0.0).send);
  return dialogue;
}

TEST(StopDialogue, SendsAtOnceAndRepeatsEveryFifthOfASecondUntilAllDevicesAnswer) {
  Dialogue dialogue(Action::kStop, {"arm", "base"});
  EXPECT_TRUE(dialogue.step(0.0).send);
  EXPECT_FALSE(dialogue.step(0.1).send);
  dialogue.observe(arm(true, true));
  const Step first = dialogue.step(0.2);
  EXPECT_TRUE(first.send);
  EXPECT_EQ(first.lines, std::vector<std::string>{"arm: stopped"});
  EXPECT_FALSE(first.ending);
  dialogue.observe(StopReport{"base", true, true, ""});
  const Step last = dialogue.step(0.3);
  ASSERT_TRUE(last.ending);
  EXPECT_EQ(last.ending->exit_code, kExitReached);
  EXPECT_FALSE(last.send);
}

TEST(StopDialogue, ALatchThatAnswersAnotherIsNoAnswer) {
  Dialogue dialogue(Action::kStop, {"arm"});
  dialogue.step(0.0);
  dialogue.observe(arm(true, false));
  EXPECT_FALSE(dialogue.step(4.9).ending);
}

TEST(StopDialogue, NamesTheDevicesThatDoNotAnswer) {
  Dialogue dialogue(Action::kStop, {"arm", "base", "lift"});
  dialogue.step(0.0);
  dialogue.observe(StopReport{"base", true, true, ""});
  EXPECT_FALSE(dialogue.step(4.9).ending);
  const Step step = dialogue.step(5.0);
  ASSERT_TRUE(step.ending);
  EXPECT_EQ(step.ending->exit_code, kExitNoAnswer);
  EXPECT_THAT(step.ending->line, HasSubstr("no answer from arm, lift within 5 s"));
}

TEST(StopDialogue, ADeviceThatStaysLatchedAfterAResetIsARefusal) {
  Dialogue dialogue(Action::kReset, {"arm"});
  dialogue.step(0.0);
  dialogue.observe(arm(true, true, "emergency button is pressed"));
  const Step step = dialogue.step(0.1);
  ASSERT_TRUE(step.ending);
  EXPECT_EQ(step.ending->exit_code, kExitRefused);
  EXPECT_EQ(step.ending->line, "arm is still stopped: emergency button is pressed");
}

TEST(StartDialogue, IsNotSentWhileAStopIsLatched) {
  Dialogue dialogue(Action::kStart, {"arm"});
  EXPECT_FALSE(dialogue.step(0.0).send);
  dialogue.observe(task(Phase::kIdle, Answers::kNobody), 0.1);
  EXPECT_FALSE(dialogue.step(0.1).send);
  dialogue.observe(arm(true, false, "comes up stopped"));
  const Step step = dialogue.step(0.2);
  EXPECT_FALSE(step.send);
  ASSERT_TRUE(step.ending);
  EXPECT_EQ(step.ending->exit_code, kExitRefused);
  EXPECT_EQ(step.ending->line, "stop is latched (arm: comes up stopped): scripts/task reset releases it");
}

TEST(StartDialogue, NamesTheCommandThatWasTyped) {
  Parameters parameters;
  parameters.command = "markservo task";
  Dialogue dialogue(Action::kStart, {"arm"}, parameters);
  dialogue.observe(arm(false));
  dialogue.observe(task(Phase::kServo, Answers::kAnother), 0.0);
  EXPECT_THAT(dialogue.step(0.0).ending->line, HasSubstr("markservo task abort ends it"));
}

TEST(StartDialogue, IsNotSentWhileATaskIsUnderWay) {
  Dialogue dialogue(Action::kStart, {"arm"});
  dialogue.observe(arm(false));
  dialogue.observe(task(Phase::kServo, Answers::kAnother), 0.0);
  const Step step = dialogue.step(0.0);
  EXPECT_FALSE(step.send);
  ASSERT_TRUE(step.ending);
  EXPECT_EQ(step.ending->exit_code, kExitRefused);
  EXPECT_THAT(step.ending->line, HasSubstr("servo red_book"));
}

TEST(StartDialogue, TellsEveryChangeOnceAndEndsLifted) {
  Dialogue dialogue = sent(Action::kStart);
  dialogue.observe(task(Phase::kLook, Answers::kUs, "looking", 100.0), 0.1);
  dialogue.observe(task(Phase::kLook, Answers::kUs, "looking", 100.1), 0.2);
  EXPECT_EQ(dialogue.step(0.2).lines, std::vector<std::string>{"   0.00 s  look red_book: looking"});
  dialogue.observe(task(Phase::kLiftOn, Answers::kUs, "", 112.5), 1.0);
  const Step going = dialogue.step(1.0);
  EXPECT_EQ(going.lines, std::vector<std::string>{"  12.50 s  lift on red_book"});
  EXPECT_FALSE(going.send);
  EXPECT_FALSE(going.ending);
  dialogue.observe(task(Phase::kHoldLifted, Answers::kUs, "", 113.0), 1.1);
  const Step last = dialogue.step(1.1);
  ASSERT_TRUE(last.ending);
  EXPECT_EQ(last.ending->exit_code, kExitReached);
  EXPECT_EQ(last.ending->line, "  13.00 s  lifted red_book");
}

TEST(StartDialogue, TellsTheDrive) {
  Dialogue dialogue = sent(Action::kStart);
  dialogue.observe(task(Phase::kDrive, Answers::kUs, "driving to x 0.20 m, y 1.05 m, 90 degrees"), 0.1);
  const Step step = dialogue.step(0.1);
  EXPECT_EQ(step.lines,
            std::vector<std::string>{"   0.00 s  drive red_book: driving to x 0.20 m, y 1.05 m, 90 degrees"});
  EXPECT_FALSE(step.ending);
}

TEST(StartDialogue, EveryBadEndHasItsReason) {
  for (const Phase phase : {Phase::kRefused, Phase::kFailed, Phase::kStopped}) {
    Dialogue dialogue = sent(Action::kStart);
    dialogue.observe(task(phase, Answers::kUs, "out of reach"), 0.1);
    const Step step = dialogue.step(0.1);
    ASSERT_TRUE(step.ending);
    EXPECT_EQ(step.ending->exit_code, kExitRefused);
    EXPECT_EQ(step.ending->line, std::string(name_of(phase)) + " red_book: out of reach");
  }
}

TEST(StartDialogue, EndsWhenAnotherCommandTakesTheTaskOver) {
  Dialogue dialogue = sent(Action::kStart);
  dialogue.observe(task(Phase::kLook), 0.1);
  dialogue.observe(task(Phase::kGoHome, Answers::kAnother), 0.2);
  const Step step = dialogue.step(0.2);
  ASSERT_TRUE(step.ending);
  EXPECT_EQ(step.ending->exit_code, kExitRefused);
}

TEST(StartDialogue, SaysWhoIsSilent) {
  Dialogue nobody(Action::kStart, {"arm"});
  nobody.step(0.0);
  EXPECT_THAT(nobody.step(5.0).ending.value().line, HasSubstr("no answer from arm: no STOP_STATE within 5 s"));

  Dialogue no_task(Action::kStart, {"arm"});
  no_task.observe(arm(false));
  no_task.step(0.0);
  EXPECT_THAT(no_task.step(5.0).ending.value().line, HasSubstr("no answer from task-manager: no TASK_STATE"));

  Dialogue deaf = sent(Action::kHome);
  deaf.observe(task(Phase::kIdle, Answers::kNobody), 4.9);
  const Step step = deaf.step(5.0);
  EXPECT_EQ(step.ending.value().exit_code, kExitNoAnswer);
  EXPECT_THAT(step.ending.value().line, HasSubstr("does not echo the command"));
}

TEST(StartDialogue, ATaskThatFallsSilentIsNotWaitedForForEver) {
  Dialogue dialogue = sent(Action::kStart);
  dialogue.observe(task(Phase::kServo), 50.0);
  EXPECT_FALSE(dialogue.step(54.9).ending);
  EXPECT_EQ(dialogue.step(55.0).ending.value().exit_code, kExitNoAnswer);
}

TEST(AbortDialogue, IsSentAtOnceWhateverTheStopDevicesSay) {
  Dialogue dialogue(Action::kAbort, {"arm"});
  EXPECT_TRUE(dialogue.step(0.0).send);
  dialogue.observe(task(Phase::kStopped, Answers::kUs, "aborted by operator"), 0.1);
  const Step step = dialogue.step(0.1);
  EXPECT_EQ(step.lines, std::vector<std::string>{"   0.00 s  stopped red_book: aborted by operator"});
  EXPECT_EQ(step.ending.value().exit_code, kExitReached);
}

}  // namespace
}  // namespace markservo::task
