#include <gtest/gtest.h>

#include "tests/system/fault_campaign/words.hpp"
#include "tests/unit/fault_campaign/forged_history.hpp"

namespace markservo::campaign {
namespace {

ForgedHistory struck_task(double until = 20.0) {
  ForgedHistory forged;
  forged.still(0.0, until)
      .start(1.0)
      .task_state(2.0, TaskState::SERVO)
      .fault(5.0, 7.0, {"mark-detector", "TARGET_POSE"});
  return forged;
}

TEST(TasksEndWithTheReason, HoldsWhenTheReasonNamesTheFault) {
  ForgedHistory forged = struck_task();
  forged.task_state(8.0, TaskState::FAILED, "TARGET_POSE is 2.1 s old");
  const Verdict verdict = tasks_end_with_the_reason(forged.timeline(), forged_bars());
  EXPECT_EQ(verdict.judged, 1);
  EXPECT_FALSE(verdict.broken());
}

TEST(TasksEndWithTheReason, HoldsWhenTheTaskIsDone) {
  ForgedHistory forged = struck_task();
  forged.task_state(8.0, TaskState::HOLD_LIFTED);
  EXPECT_FALSE(tasks_end_with_the_reason(forged.timeline(), forged_bars()).broken());
}

TEST(TasksEndWithTheReason, BreaksForAReasonThatNamesSomethingElse) {
  ForgedHistory forged = struck_task();
  forged.task_state(8.0, TaskState::FAILED, "the hand's mark is hidden");
  EXPECT_TRUE(tasks_end_with_the_reason(forged.timeline(), forged_bars()).broken());
}

TEST(TasksEndWithTheReason, BreaksWhenTheTaskIsGoneWithoutAReason) {
  ForgedHistory forged = struck_task();
  forged.task_state(8.0, TaskState::IDLE);
  EXPECT_TRUE(tasks_end_with_the_reason(forged.timeline(), forged_bars()).broken());
}

TEST(TasksEndWithTheReason, TakesNoPartOfANameForAName) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).start(1.0).task_state(2.0, TaskState::SERVO).fault(5.0, 7.0, {"STOP"});
  forged.task_state(8.0, TaskState::STOPPED, "stop: no STOP_STATE of arm");
  EXPECT_TRUE(tasks_end_with_the_reason(forged.timeline(), forged_bars()).broken());
}

TEST(TasksEndWithTheReason, BreaksForATaskThatStands) {
  // Before the patience of 40 s has passed: that nothing changes for 22 s tells it.
  ForgedHistory forged = struck_task(31.0);
  forged.task_state(8.0, TaskState::SERVO);
  EXPECT_TRUE(tasks_end_with_the_reason(forged.timeline(), forged_bars()).broken());
}

// The arm goes on; `end`: s, of the world.
ForgedHistory task_that_goes_on(double end) {
  ForgedHistory forged;
  forged.world(
      0.0, end, [](double t) { return 0.01 * t; }, [](double) { return 0.0; });
  forged.start(1.0)
      .task_state(2.0, TaskState::SERVO)
      .fault(5.0, 7.0, {"TARGET_POSE"})
      .task_state(8.0, TaskState::SERVO);
  return forged;
}

TEST(TasksEndWithTheReason, WaitsForATaskThatMoves) {
  EXPECT_FALSE(tasks_end_with_the_reason(task_that_goes_on(20.0).timeline(), forged_bars()).broken());
}

TEST(TasksEndWithTheReason, WaitsByTheWorldsTimeAndNotForEver) {
  ForgedHistory slow_machine = task_that_goes_on(20.0);
  slow_machine.ended(60.0);
  EXPECT_FALSE(tasks_end_with_the_reason(slow_machine.timeline(), forged_bars()).broken());
  EXPECT_TRUE(tasks_end_with_the_reason(task_that_goes_on(49.0).timeline(), forged_bars()).broken());
}

TEST(TasksEndWithTheReason, AsksWhatStoppedATaskThatHadEnded) {
  ForgedHistory kept;
  kept.still(0.0, 20.0).start(1.0).task_state(2.0, TaskState::HOLD_LIFTED).fault(5.0, 7.0, {"TARGET_POSE"});
  kept.task_state(8.0, TaskState::HOLD_LIFTED);
  EXPECT_FALSE(tasks_end_with_the_reason(kept.timeline(), forged_bars()).broken());
  ForgedHistory stopped;
  stopped.still(0.0, 20.0).start(1.0).task_state(2.0, TaskState::HOLD_LIFTED).fault(5.0, 7.0, {"TARGET_POSE"});
  stopped.task_state(8.0, TaskState::STOPPED, "it fell");
  EXPECT_TRUE(tasks_end_with_the_reason(stopped.timeline(), forged_bars()).broken());
}

TEST(TasksEndWithTheReason, BreaksWhenNothingIsToldAnyMore) {
  EXPECT_TRUE(tasks_end_with_the_reason(struck_task().timeline(), forged_bars()).broken());
}

TEST(RecordingGoesOn, HoldsForARecordingWithAPauseForTheNextPart) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).fault(8.0, 9.0, {}).recorded({{0.0, 8.0}, {11.0, 20.0}}, 20.0, {{7.6, 11.0}});
  const Verdict verdict = recording_goes_on(forged.timeline(), forged_bars());
  EXPECT_EQ(verdict.judged, 2);
  EXPECT_FALSE(verdict.broken());
}

TEST(RecordingGoesOn, BreaksWhenItEndsWithTheFault) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).fault(8.0, 9.0, {}).recorded({{0.0, 8.0}}, 20.0);
  EXPECT_TRUE(recording_goes_on(forged.timeline(), forged_bars()).broken());
}

TEST(RecordingGoesOn, BreaksWhenWhatCameBeforeCannotBeRead) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).fault(8.0, 9.0, {}).recorded({{0.0, 4.0}, {9.0, 20.0}}, 20.0);
  EXPECT_TRUE(recording_goes_on(forged.timeline(), forged_bars()).broken());
}

TEST(RecordingGoesOn, MissesNothingWhereNothingWasSaid) {
  ForgedHistory forged;
  forged.still(0.0, 8.0).still(16.0, 20.0).fault(8.0, 15.0, {}).recorded({{0.0, 8.0}, {16.0, 20.0}}, 20.0);
  EXPECT_FALSE(recording_goes_on(forged.timeline(), forged_bars()).broken());
}

TEST(RecordingGoesOn, BreaksWhenTheManifestDoesNotTellWhatWasMissed) {
  ForgedHistory untold;
  untold.still(0.0, 20.0).fault(8.0, 9.0, {}).recorded({{0.0, 8.0}, {11.0, 20.0}}, 20.0);
  EXPECT_TRUE(recording_goes_on(untold.timeline(), forged_bars()).broken());
  ForgedHistory untrue;
  untrue.still(0.0, 20.0).fault(8.0, 9.0, {}).recorded({{0.0, 20.0}}, 20.0, {{8.0, 12.0}});
  EXPECT_TRUE(recording_goes_on(untrue.timeline(), forged_bars()).broken());
}

TEST(RecordingGoesOn, BreaksWhenTheManifestSaysThatItEndedByItself) {
  ForgedHistory forged;
  forged.still(0.0, 20.0).fault(8.0, 9.0, {}).recorded({{0.0, 20.0}}, 20.0, {}, "logger failed");
  EXPECT_TRUE(recording_goes_on(forged.timeline(), forged_bars()).broken());
}

TEST(WordsAreClean, HoldsForOrdinaryText) {
  ForgedHistory forged;
  forged.printed("visual-servo.log", "12:00:00.000 visual-servo info hold: 5 µm, ready\n\tmore\n");
  const Verdict verdict = words_are_clean(forged.timeline(), forged_bars());
  EXPECT_EQ(verdict.judged, 1);
  EXPECT_FALSE(verdict.broken());
}

TEST(WordsAreClean, BreaksForWhatCommandsATerminal) {
  for (const std::string bad : {"\x1b[31m", "\x07", "\r", "\x7f",
                                "\xc2\x9b"
                                "31m",
                                "\xe2\x80\xae", "\xff", "\xc0\x80"}) {
    ForgedHistory forged;
    forged.printed("visual-servo.log", "said " + bad + " so\n");
    EXPECT_TRUE(words_are_clean(forged.timeline(), forged_bars()).broken()) << unclean(bad);
  }
}

TEST(WordsAreClean, BreaksForALineThatATextMadeUp) {
  ForgedHistory forged;
  forged.printed("visual-servo.log", "stopped: red\nFORGED line\n");
  EXPECT_TRUE(words_are_clean(forged.timeline(), forged_bars()).broken());
}

TEST(Judge, JudgesAllTwelve) {
  ForgedHistory forged;
  forged.still(0.0, 5.0);
  EXPECT_EQ(judge(forged.timeline(), forged_bars()).size(), 12U);
}

}  // namespace
}  // namespace markservo::campaign
