#include "services/mmi/scene/state_changes.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace markservo::mmi {
namespace {

class ChangesOfState : public ::testing::Test {
 protected:
  // The text of the change that the report tells; empty if it tells none.
  std::string text(const Report& report) {
    at_ += 1000;
    newest_ = changes_.observe(report, at_, 1e-6 * static_cast<double>(at_));
    return newest_ ? newest_->text : "";
  }
  bool tells(const Report& report) { return !text(report).empty(); }

  StateChanges changes_;
  std::int64_t at_ = 5'000'000;  // us
  std::optional<StateChange> newest_;
};

TEST_F(ChangesOfState, AreNumberedWithoutAGapAndCarryWhenTheyWereHeard) {
  EXPECT_EQ(changes_.observe(TaskReport{1, TaskPhase::kIdle, 0, "", ""}, 70, 70.0)->number, 1);
  EXPECT_FALSE(changes_.observe(TaskReport{1, TaskPhase::kIdle, 0, "", ""}, 71, 71.0));
  StateChange trouble;
  trouble.kind = ChangeKind::kTrouble;
  EXPECT_EQ(changes_.tell(trouble).number, 2);
  const auto change = changes_.observe(TaskReport{1, TaskPhase::kLook, 0, "", ""}, 72, 72.0);
  EXPECT_EQ(change->number, 3);
  EXPECT_EQ(change->at, 72);
}

TEST_F(ChangesOfState, OfATaskAreItsTransitionsInOrder) {
  EXPECT_EQ(text(TaskReport{1, TaskPhase::kIdle, 0, "", ""}), "IDLE");
  EXPECT_EQ(text(TaskReport{1, TaskPhase::kLook, 1, "red_book", ""}), "IDLE -> LOOK red_book");
  EXPECT_EQ(text(TaskReport{1, TaskPhase::kServo, 1, "red_book", ""}), "LOOK -> SERVO");
  EXPECT_EQ(text(TaskReport{1, TaskPhase::kServo, 1, "red_book", ""}), "");
  EXPECT_EQ(text(TaskReport{1, TaskPhase::kGrip, 1, "red_book", ""}), "SERVO -> GRIP");
  EXPECT_EQ(text(TaskReport{1, TaskPhase::kRelease, 2, "red_book", ""}), "GRIP -> RELEASE, attempt 2");
  EXPECT_EQ(text(TaskReport{1, TaskPhase::kFailed, 2, "red_book", "lost"}), "RELEASE -> FAILED, attempt 2: lost");
  EXPECT_EQ(newest_->channel, "TASK_STATE");
  EXPECT_EQ(newest_->kind, ChangeKind::kTask);
  EXPECT_EQ(newest_->state, "FAILED");
  EXPECT_EQ(newest_->level, Level::kBad);
}

TEST_F(ChangesOfState, OfATaskAreAlsoItsTargetAttemptAndWhatItWaitsFor) {
  const TaskReport task{1, TaskPhase::kLook, 1, "red_book", ""};
  text(task);
  TaskReport other = task;
  other.target = "blue_book";
  EXPECT_EQ(text(other), "LOOK blue_book");
  other.attempt = 2;
  EXPECT_EQ(text(other), "LOOK blue_book, attempt 2");
  other.reason = "waits for the base";
  EXPECT_EQ(text(other), "LOOK blue_book, attempt 2: waits for the base");
}

TEST_F(ChangesOfState, OfAReasonAreItsWordsAndNotItsNumbers) {
  EXPECT_TRUE(tells(BaseReport{1, BaseState::kDriving, ""}));
  EXPECT_EQ(text(BaseReport{1, BaseState::kBlocked, "something stands 0.31 m ahead"}),
            "base: BLOCKED: something stands 0.31 m ahead");
  EXPECT_EQ(newest_->level, Level::kWarning);
  EXPECT_FALSE(tells(BaseReport{1, BaseState::kBlocked, "something stands 0.30 m ahead"}));
  EXPECT_TRUE(tells(BaseReport{1, BaseState::kBlocked, "something stands 0.30 m left"}));
  EXPECT_TRUE(tells(BaseReport{1, BaseState::kDriving, ""}));
}

TEST_F(ChangesOfState, OfTheArmAreItsStateRestAndReason) {
  EXPECT_EQ(text(ServoReport{1, ServoState::kPosture, false, ""}), "arm: POSTURE");
  EXPECT_EQ(text(ServoReport{1, ServoState::kPosture, true, ""}), "arm: POSTURE, settled");
  EXPECT_EQ(text(ServoReport{1, ServoState::kLost, false, "mark hand: unseen"}), "arm: LOST: mark hand: unseen");
  EXPECT_FALSE(tells(ServoReport{1, ServoState::kLost, false, "mark hand: unseen"}));
}

TEST_F(ChangesOfState, OfThePoseAreItsStateAlone) {
  EXPECT_EQ(text(PoseReport{1, 1, LocalisationState::kLost, {}, 0.2, "no round"}), "pose: LOST: no round");
  EXPECT_EQ(newest_->level, Level::kBad);
  EXPECT_FALSE(tells(PoseReport{2, 1, LocalisationState::kLost, {}, 0.2, "another reason"}));
  EXPECT_EQ(text(PoseReport{3, 1, LocalisationState::kLocalised, {}, 0.2, ""}), "pose: LOCALISED");
}

TEST_F(ChangesOfState, OfEachStopDeviceAreItsLatchAndTheRequestObeyed) {
  EXPECT_EQ(text(StopReport{1, "arm", true, 0, 0, "just started"}), "stop of arm: latched: just started");
  EXPECT_EQ(text(StopReport{2, "base", true, 0, 0, ""}), "stop of base: latched");
  EXPECT_FALSE(tells(StopReport{1, "arm", true, 0, 0, "just started"}));
  EXPECT_EQ(text(StopReport{1, "arm", false, 9, 1, ""}), "stop of arm: free");
  EXPECT_TRUE(tells(StopReport{1, "arm", false, 9, 2, ""}));
  EXPECT_EQ(newest_->key, "arm");
  EXPECT_EQ(newest_->state, "free");
}

TEST_F(ChangesOfState, OfARequestAreToldOnceHoweverOftenItIsRepeated) {
  EXPECT_EQ(text(StopRequestReport{7, 1, false, "page", "Escape"}), "STOP by page: Escape");
  EXPECT_EQ(newest_->kind, ChangeKind::kCommand);
  EXPECT_EQ(newest_->channel, "STOP");
  EXPECT_FALSE(tells(StopRequestReport{7, 1, false, "page", "Escape"}));
  EXPECT_EQ(text(StopRequestReport{7, 2, true, "", ""}), "RESET by somebody");
  EXPECT_FALSE(tells(StopRequestReport{7, 1, false, "page", "Escape"}));
  EXPECT_EQ(text(CommandReport{7, 1, CommandKind::kStart, "red_book", true, true}),
            "START red_book, drive there, carry it");
  EXPECT_FALSE(tells(CommandReport{7, 1, CommandKind::kStart, "red_book", true, true}));
  EXPECT_EQ(text(CommandReport{8, 1, CommandKind::kAbort, "", false, false}), "ABORT");
  EXPECT_EQ(text(CommandReport{8, 2, CommandKind::kHome, "", false, false}), "HOME");
}

TEST_F(ChangesOfState, OfAServiceAreItsStateItsReasonAndItsRestart) {
  EXPECT_EQ(text(ServiceReport{1, "visual-servo", "robot", "ready", ""}), "visual-servo@robot: ready");
  EXPECT_EQ(newest_->level, Level::kInfo);
  EXPECT_FALSE(tells(ServiceReport{1, "visual-servo", "robot", "ready", ""}));
  EXPECT_EQ(text(ServiceReport{1, "visual-servo", "robot", "stale", "no pictures for 1.2 s"}),
            "visual-servo@robot: stale: no pictures for 1.2 s");
  EXPECT_EQ(newest_->level, Level::kWarning);
  EXPECT_FALSE(tells(ServiceReport{1, "visual-servo", "robot", "stale", "no pictures for 1.3 s"}));
  EXPECT_EQ(text(ServiceReport{2, "visual-servo", "robot", "stale", "no pictures for 1.3 s"}),
            "visual-servo@robot: began again: stale: no pictures for 1.3 s");
  EXPECT_EQ(text(ServiceReport{3, "visual-servo", "desk", "ready", ""}), "visual-servo@desk: ready");
  EXPECT_TRUE(tells(ServiceReport{4, "task-manager", "robot", "grip", "closing the hand"}));
  EXPECT_EQ(newest_->level, Level::kInfo) << "it tells what it does";
}

TEST_F(ChangesOfState, OfAProcessAreItsStateItsRestartsAndWhy) {
  EXPECT_EQ(text(ProcessReport{1, "recorder", "robot", ProcessState::kRunning, 0, ""}),
            "process recorder@robot: RUNNING");
  EXPECT_EQ(text(ProcessReport{1, "recorder", "robot", ProcessState::kWaiting, 0, "killed by signal 9"}),
            "process recorder@robot: WAITING: killed by signal 9");
  EXPECT_EQ(newest_->level, Level::kBad);
  EXPECT_TRUE(tells(ProcessReport{1, "recorder", "robot", ProcessState::kRunning, 1, "killed by signal 9"}));
  EXPECT_FALSE(tells(ProcessReport{1, "recorder", "robot", ProcessState::kRunning, 1, "killed by signal 9"}));
}

TEST_F(ChangesOfState, OfARecordingAreItsBeginItsPartsAndItsEnd) {
  EXPECT_EQ(text(RecorderReport{1, "logs/a", "robot", true, 1, ""}), "logs/a: recording");
  EXPECT_EQ(newest_->key, "robot:logs/a");
  EXPECT_EQ(text(RecorderReport{1, "logs/a", "robot", true, 2, ""}), "logs/a: recording, part 2");
  EXPECT_EQ(text(RecorderReport{1, "logs/a", "robot", false, 2, "the disk is full"}),
            "logs/a: ended, part 2: the disk is full");
  EXPECT_EQ(newest_->level, Level::kBad);
}

TEST_F(ChangesOfState, OfTwoThatWriteAsOneAreToldWithOneChangeEach) {
  EXPECT_TRUE(tells(TaskReport{1, TaskPhase::kServo, 1, "", ""}));
  EXPECT_TRUE(tells(TaskReport{2, TaskPhase::kIdle, 0, "", ""}));
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(tells(TaskReport{1, TaskPhase::kServo, 1, "", ""}));
    EXPECT_FALSE(tells(TaskReport{2, TaskPhase::kIdle, 0, "", ""}));
  }
  EXPECT_EQ(text(TaskReport{1, TaskPhase::kGrip, 1, "", ""}), "SERVO -> GRIP");
}

TEST_F(ChangesOfState, OfAWriterThatBeganAgainAreToldWhereItSaysAnotherThing) {
  EXPECT_TRUE(tells(StopReport{1, "arm", true, 0, 0, ""}));
  EXPECT_FALSE(tells(StopReport{2, "arm", true, 0, 0, ""}));
  EXPECT_TRUE(tells(StopReport{3, "arm", false, 9, 1, ""}));
}

TEST_F(ChangesOfState, AreNotToldOfWhatHasNoState) {
  EXPECT_FALSE(tells({}));
  EXPECT_FALSE(tells(JointReport{}));
  EXPECT_FALSE(tells(RoundReport{}));
}

TEST(ChangeAsJson, HasTheFieldsOfTheProtocol) {
  const StateChange change{4,    9'007'199'254'740'993, "STOP_STATE", "arm", ChangeKind::kStop, "latched",
                           "as", Level::kWarning};
  EXPECT_EQ(json_of(change), nlohmann::ordered_json({{"number", 4},
                                                     {"at", "9007199254740993"},
                                                     {"channel", "STOP_STATE"},
                                                     {"key", "arm"},
                                                     {"kind", "stop"},
                                                     {"state", "latched"},
                                                     {"text", "as"},
                                                     {"level", "warning"}}));
}

}  // namespace
}  // namespace markservo::mmi
