// What is a trouble and what is none: blinks, beginnings, and what follows from something else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/mmi/healthy_robot.hpp"

namespace markservo::mmi {
namespace {

using ::testing::HasSubstr;

TEST(StopTroubles, ARobotThatComesUpStoppedIsInNone) {
  HealthyRobot robot;
  for (StopWord& stop : robot.stops) stop = {0, stop.device, true, false, "comes up stopped"};
  EXPECT_TRUE(robot.pass(20.0).empty());
}

TEST(StopTroubles, ADeviceThatComesUpStoppedInAnotherOnesWorkIsLatched) {
  HealthyRobot robot;
  robot.pass(2.0);
  robot.stops[1] = {0, "base", true, false, "comes up stopped"};
  EXPECT_EQ(of_code(robot.pass(0.5), TroubleCode::kStopLatched)->subject, "base");
}

TEST(StopTroubles, AllLatchedDevicesAreOneTroubleWithTheReasonOnce) {
  HealthyRobot robot;
  for (StopWord& stop : robot.stops) stop = {0, stop.device, true, true, "page: asked by somebody"};
  const auto trouble = of_code(robot.pass(0.5), TroubleCode::kStopLatched);
  ASSERT_TRUE(trouble);
  EXPECT_EQ(trouble->subject, "arm, base");
  EXPECT_EQ(trouble->text, "stopped: page: asked by somebody");
}

TEST(StopTroubles, ADeviceThatNeverSpokeIsSilentOnceSomethingWouldMoveIt) {
  HealthyRobot robot;
  robot.silent = {"base", "visual-servo"};
  EXPECT_TRUE(robot.pass(10.0).empty());
  robot.silent = {"base"};
  const auto trouble = of_code(robot.pass(7.0), TroubleCode::kStopDeviceSilent);
  ASSERT_TRUE(trouble);
  EXPECT_EQ(trouble->subject, "base");
  EXPECT_THAT(trouble->text, HasSubstr("has not said yet"));
}

TEST(WriterTroubles, ARestartIsNone) {
  HealthyRobot robot;
  robot.silent = {"JOINT_STATE"};
  for (std::int64_t session = 50; session < 60; ++session) {
    robot.each_tick = [&] { robot.say("JOINT_STATE", session); };
    EXPECT_FALSE(is_ever_told(robot, TroubleCode::kSecondWriter, 2.0));
  }
}

TEST(WriterTroubles, WhatWasUnderWayWhenAnotherTookOverIsNone) {
  HealthyRobot robot;
  robot.silent = {"JOINT_STATE"};
  robot.say("JOINT_STATE", 50);
  robot.say("JOINT_STATE", 51);
  robot.say("JOINT_STATE", 50);
  robot.each_tick = [&] { robot.say("JOINT_STATE", 51); };
  EXPECT_FALSE(is_ever_told(robot, TroubleCode::kSecondWriter, 3.0));
}

TEST(WriterTroubles, ManyMayWriteWhereThatIsMeant) {
  HealthyRobot robot;
  robot.each_tick = [&] {
    robot.say("STOP", 50, 0, false);
    robot.say("STOP", 51, 0, false);
  };
  EXPECT_TRUE(robot.pass(3.0).empty());
}

TEST(WriterTroubles, TwoThatClaimToBeOneDeviceAreTold) {
  HealthyRobot robot;
  robot.each_tick = [&] {
    robot.say("STOP_STATE", 50, 0, true, "arm");
    robot.say("STOP_STATE", 51, 0, true, "arm");
    robot.say("STOP_STATE", 50, 0, true, "base");
  };
  const auto trouble = of_code(robot.pass(1.0), TroubleCode::kSecondWriter);
  ASSERT_TRUE(trouble);
  EXPECT_EQ(trouble->subject, "arm");
  EXPECT_EQ(trouble->text, "two claim to be the arm: session 51 and session 50");
}

TEST(WriterTroubles, OfAChannelThatIsNotHeardHereItsReaderCounts) {
  HealthyRobot robot;
  robot.silent = {"STEREO_FRAME"};
  robot.services[0].channels[0].second_writer = true;
  EXPECT_EQ(of_code(robot.pass(2.0), TroubleCode::kSecondWriter)->subject, "STEREO_FRAME");
  robot.services[0].channels[0].second_writer = false;
  EXPECT_TRUE(robot.pass(2.0).empty());
}

TEST(WriterTroubles, AReadersWordThatLingersIsNoneWhereTheChannelIsHeard) {
  HealthyRobot robot;
  robot.services[0].channels[0].second_writer = true;
  EXPECT_TRUE(robot.pass(5.0).empty());
}

TEST(ProcessTroubles, OneThatIsKilledOnceAndStartedAtOnceIsNone) {
  HealthyRobot robot;
  robot.pass(2.0);
  ProcessWord dead = robot.processes[1];
  dead.state = ProcessState::kWaiting;
  robot.watch.observe(dead, robot.now);
  robot.pass(0.3);
  robot.watch.observe(robot.processes[1], robot.now);
  EXPECT_FALSE(is_ever_told(robot, TroubleCode::kProcessDead, 3.0));
}

TEST(ProcessTroubles, OneThatWasToldToStopIsNone) {
  HealthyRobot robot;
  robot.pass(2.0);
  robot.processes[0].state = ProcessState::kStopped;
  robot.silent = {"mark-detector"};
  EXPECT_TRUE(robot.pass(10.0).empty());
}

TEST(ProcessTroubles, OneThatEndedOrCannotBeStartedSaysHowToLookAndStartIt) {
  for (const ProcessState state : {ProcessState::kEnded, ProcessState::kFailed}) {
    HealthyRobot robot;
    robot.pass(2.0);
    robot.processes[0].state = state;
    robot.processes[0].why = "its configuration is bad (exit code 2)";
    const auto trouble = of_code(robot.pass(2.0), TroubleCode::kProcessDead);
    ASSERT_TRUE(trouble);
    EXPECT_EQ(trouble->text, "mark-detector does not run: its configuration is bad (exit code 2)");
    EXPECT_EQ(trouble->remedy, "scripts/stack logs mark-detector says why; then scripts/stack restart mark-detector");
  }
}

TEST(ProcessTroubles, TheWatchsWordOfASilentOneCounts) {
  HealthyRobot robot;
  robot.pass(2.0);
  robot.processes[0].state = ProcessState::kSilent;
  EXPECT_EQ(of_code(robot.pass(2.0), TroubleCode::kProcessHung)->subject, "mark-detector");
}

TEST(ProcessTroubles, WhoSaysAnythingIsNotSilent) {
  HealthyRobot robot;
  robot.pass(2.0);
  robot.silent = {"mark-detector"};
  robot.each_tick = [&] { robot.say("MARK_DETECTION", 11); };
  EXPECT_TRUE(robot.pass(10.0).empty());
}

TEST(ProcessTroubles, AToolThatEndsIsNone) {
  HealthyRobot robot;
  robot.services.push_back(HealthyRobot::service("task-operator", 40));
  robot.pass(3.0);
  robot.silent = {"task-operator"};
  EXPECT_TRUE(robot.pass(10.0).empty());
}

TEST(ProcessTroubles, ASilentWatchIsToldAndNothingOfItsProcesses) {
  HealthyRobot robot;
  robot.processes[0].state = ProcessState::kFailed;
  robot.pass(5.0);
  robot.silent = {"PROCESS_STATUS"};
  const std::vector<Trouble> troubles = robot.pass(6.0);
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_EQ(troubles[0].code, TroubleCode::kProcessHung);
  EXPECT_EQ(troubles[0].subject, "stack-watch");
}

TEST(LossTroubles, SomeLostMessagesAreNone) {
  HealthyRobot robot;
  robot.lost_each_second = 4;
  EXPECT_TRUE(robot.pass(10.0).empty());
}

TEST(LossTroubles, WhatAServiceMissedOfAWriterThatItRefusedIsNone) {
  HealthyRobot robot;
  robot.pass(3.0);
  ReceivedWord& channel = robot.services[1].channels[0];
  channel.refused += 80;
  robot.pass(1.0);
  channel.lost += 80;
  EXPECT_FALSE(is_ever_told(robot, TroubleCode::kMessagesLost, 3.0));
}

TEST(LossTroubles, WhatAServiceMissedWhileItHungIsNone) {
  HealthyRobot robot;
  robot.pass(3.0);
  robot.silent = {"visual-servo"};
  robot.pass(8.0);
  robot.silent = {};
  robot.services[1].channels[0].lost += 600;
  EXPECT_FALSE(is_ever_told(robot, TroubleCode::kMessagesLost, 3.0));
}

TEST(LossTroubles, AServiceWhoseWordsGetLostTooIsNotCalledHungAtOnce) {
  HealthyRobot robot;
  robot.lost_each_second = 20;
  robot.pass(3.0);
  robot.silent = {"mark-detector"};
  const std::vector<Trouble> troubles = robot.pass(5.0);
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_EQ(troubles[0].code, TroubleCode::kMessagesLost);
}

TEST(ClockTroubles, OneMessageFromTheFutureAndClocksThatNearlyAgreeAreNone) {
  HealthyRobot robot;
  robot.pass(1.0);
  robot.say("JOINT_COMMAND", 60, 5'000'000);
  EXPECT_FALSE(is_ever_told(robot, TroubleCode::kClockAhead, 3.0));
  robot.clock_ahead_us = 20'000;
  EXPECT_TRUE(robot.pass(3.0).empty());
}

TEST(ClockTroubles, WhereTheClockHereIsAsWrongTheServicesWordCounts) {
  HealthyRobot robot;
  robot.services[0].state = "stale";
  robot.services[0].reason =
      "r1/STEREO_FRAME: all refused: utime is 30 s ahead of this host's clock; allowed: at most 20 ms";
  const std::vector<Trouble> troubles = robot.pass(5.0);
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_EQ(troubles[0].code, TroubleCode::kClockAhead);
  EXPECT_EQ(troubles[0].subject, "STEREO_FRAME");
  EXPECT_THAT(troubles[0].text, HasSubstr("30 s ahead"));
}

TEST(BaseTroubles, ASearchForTheFirstPoseIsNoneUnlessADriveWaitsForIt) {
  HealthyRobot robot;
  robot.pose = {0, LocalisationState::kSearching, {}, 100.0, 100.0, "no tag of the map was read yet"};
  EXPECT_TRUE(robot.pass(5.0).empty());
  robot.base = {0, BaseState::kLost, 0.0, "ROBOT_POSE is searching: no tag of the map was read yet"};
  EXPECT_THAT(of_code(robot.pass(1.0), TroubleCode::kPoseLost)->text, HasSubstr("no tag of the map"));
}

TEST(RecordingTroubles, OneThatEndedAsItWasToldIsNone) {
  HealthyRobot robot;
  robot.pass(3.0);
  robot.recorder.recording = false;
  EXPECT_TRUE(robot.pass(1.0).empty());
  robot.silent = {"RECORDER_STATUS"};
  EXPECT_TRUE(robot.pass(10.0).empty());
}

TEST(RecordingTroubles, AnInterruptionOfHalfASecondIsNone) {
  HealthyRobot robot;
  robot.pass(3.0);
  RecorderWord interrupted = robot.recorder;
  interrupted.recording = false;
  interrupted.why = "lcm-logger died";
  robot.watch.observe(interrupted, robot.now);
  robot.pass(0.5);
  robot.watch.observe(robot.recorder, robot.now);
  EXPECT_FALSE(is_ever_told(robot, TroubleCode::kRecordingEnded, 3.0));
}

TEST(RecordingTroubles, ARecorderThatWasKilledIsToldFourSecondsAfterItsLastWord) {
  HealthyRobot robot;
  robot.pass(3.0);
  robot.silent = {"RECORDER_STATUS"};
  EXPECT_TRUE(is_ever_told(robot, TroubleCode::kRecordingEnded, 4.0));
  EXPECT_THAT(robot.pass(1.0).front().remedy, HasSubstr("scripts/record --finish logs/today"));
}

TEST(RecordingTroubles, AnotherRecordingMendsIt) {
  HealthyRobot robot;
  robot.pass(3.0);
  robot.silent = {"RECORDER_STATUS"};
  RecorderWord ended = robot.recorder;
  ended.recording = false;
  ended.why = "the disk is full";
  robot.watch.observe(ended, robot.now);
  EXPECT_TRUE(of_code(robot.pass(2.0), TroubleCode::kRecordingEnded));
  robot.recorder.folder = "logs/next";
  robot.silent = {};
  EXPECT_TRUE(robot.pass(2.0).empty());
}

TEST(Remedies, ATextFromTheBusIsNoCommand) {
  EXPECT_EQ(typable("mark-detector", "NAME"), "mark-detector");
  EXPECT_EQ(typable("logs/2026-01-02", "FOLDER"), "logs/2026-01-02");
  for (const char* bad : {"", "$(reboot)", "a b", "a;b", "-rf", "b\xc3\xbc"}) EXPECT_EQ(typable(bad, "NAME"), "NAME");
}

TEST(Remedies, NameTheCommandsAsThePersonTypesThem) {
  const Remedies remedies(text::TypedCommand("markservo mmi"));
  EXPECT_THAT(remedies.stop_latched(), HasSubstr("markservo task reset"));
}

}  // namespace
}  // namespace markservo::mmi
