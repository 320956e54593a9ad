// Each trouble on a robot that is otherwise well: told in time, first and with its subject; gone in time.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/unit/mmi/healthy_robot.hpp"

namespace markservo::mmi {
namespace {

using ::testing::HasSubstr;

struct Fault {
  TroubleCode code;
  const char* subject;
  const char* text;    // a part of it
  const char* remedy;  // likewise
  double within;       // s, in which it is told: 1 s after the message that tells it, which may be a second away, and
                       // silence after 4 s
  std::function<void(HealthyRobot&)> begin;
  std::function<void(HealthyRobot&)> mend;
};

constexpr double kTold = 1.0;
constexpr double kToldOnceASecond = 2.0;
constexpr double kSilence = 4.0;

void second_writer(HealthyRobot& robot) {
  robot.each_tick = [&robot] { robot.say("JOINT_STATE", 99); };
}

void nothing_else(HealthyRobot& robot) {
  robot.each_tick = nullptr;
}

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = {
      {TroubleCode::kStopDeviceSilent, "base", "does not say any more whether it is stopped", "power", kSilence,
       [](HealthyRobot& robot) { robot.silent = {"base"}; }, [](HealthyRobot& robot) { robot.silent = {}; }},
      {TroubleCode::kSecondWriter, "JOINT_STATE", "simulator (process 13 on host)", "scripts/task reset", kTold,
       second_writer, nothing_else},
      {TroubleCode::kProcessDead, "mark-detector", "it crashed 3 times", "scripts/stack logs mark-detector",
       kToldOnceASecond,
       [](HealthyRobot& robot) {
         robot.processes[0].state = ProcessState::kWaiting;
         robot.processes[0].why = "it crashed 3 times in a row: started again in 2 s";
       },
       [](HealthyRobot& robot) { robot.processes[0].state = ProcessState::kRunning; }},
      {TroubleCode::kProcessHung, "mark-detector", "says nothing any more", "scripts/stack restart mark-detector",
       kSilence, [](HealthyRobot& robot) { robot.silent = {"mark-detector"}; },
       [](HealthyRobot& robot) { robot.silent = {}; }},
      {TroubleCode::kClockAhead, "simulator", "is 3600 s ahead", "chronyc makestep", kTold,
       [](HealthyRobot& robot) { robot.clock_ahead_us = 3'600'000'000; },
       [](HealthyRobot& robot) { robot.clock_ahead_us = 0; }},
      {TroubleCode::kMessagesLost, "JOINT_STATE", "visual-servo does not get every JOINT_STATE: about 20 % are lost",
       "scripts/doctor", kToldOnceASecond, [](HealthyRobot& robot) { robot.lost_each_second = 20; },
       [](HealthyRobot& robot) { robot.lost_each_second = 0; }},
      {TroubleCode::kCameraSilent, "cameras", "no picture comes any more", "scripts/doctor --cameras", kSilence,
       [](HealthyRobot& robot) { robot.silent = {"STEREO_FRAME"}; }, [](HealthyRobot& robot) { robot.silent = {}; }},
      {TroubleCode::kStopLatched, "arm", "operator: enough", "scripts/task reset", kTold,
       [](HealthyRobot& robot) {
         robot.stops[0] = {0, "arm", true, true, "operator: enough"};
       },
       [](HealthyRobot& robot) {
         robot.stops[0] = {0, "arm", false, true, "operator: go"};
       }},
      {TroubleCode::kMarkUnseen, "red_book", "seen by one camera only", "uncover the mark", kTold,
       [](HealthyRobot& robot) { robot.marks.marks[1].status = MarkStatus::kSeenByOne; },
       [](HealthyRobot& robot) { robot.marks.marks[1].status = MarkStatus::kLocated; }},
      {TroubleCode::kHandUnseen, "hand", "cut by an image border", "view of the hand", kTold,
       [](HealthyRobot& robot) { robot.marks.marks[0].status = MarkStatus::kClipped; },
       [](HealthyRobot& robot) { robot.marks.marks[0].status = MarkStatus::kLocated; }},
      {TroubleCode::kPoseLost, "base", "the reads contradict the pose", "push the robot", kTold,
       [](HealthyRobot& robot) {
         robot.pose.state = LocalisationState::kLost;
         robot.pose.reason = "the reads contradict the pose";
       },
       [](HealthyRobot& robot) { robot.pose.state = LocalisationState::kLocalised; }},
      {TroubleCode::kBaseBlocked, "base", "sonar 3", "clear the way", kTold,
       [](HealthyRobot& robot) {
         robot.base = {0, BaseState::kBlocked, 0.8, "sonar 3 sees something"};
       },
       [](HealthyRobot& robot) { robot.base.state = BaseState::kDriving; }},
      {TroubleCode::kRecordingEnded, "logs/today", "the disk is full", "scripts/record", kToldOnceASecond,
       [](HealthyRobot& robot) {
         robot.recorder.recording = false;
         robot.recorder.why = "the disk is full";
       },
       [](HealthyRobot& robot) {
         robot.recorder.recording = true;
         robot.recorder.folder = "logs/later";
       }},
      {TroubleCode::kTargetRefused, "red_book", "out of reach", "scripts/task start --target red_book", kTold,
       [](HealthyRobot& robot) {
         robot.task.phase = TaskPhase::kRefused;
         robot.task.reason = "out of reach";
       },
       [](HealthyRobot& robot) { robot.task.phase = TaskPhase::kLook; }},
  };
  return all;
}

class EveryTrouble : public ::testing::TestWithParam<std::size_t> {};

TEST_P(EveryTrouble, IsToldInTimeFirstAndAloneAndIsGoneTwoSecondsAfterItIsMended) {
  const Fault& fault = faults()[GetParam()];
  HealthyRobot robot;
  EXPECT_TRUE(robot.pass(5.0).empty());
  const std::int64_t before = robot.at();

  fault.begin(robot);
  const auto is_told = [&](const std::vector<Trouble>& troubles) {
    return !troubles.empty() && troubles.front().code == fault.code;
  };
  EXPECT_LE(robot.until(is_told, 10.0), fault.within + 1e-6);
  const std::vector<Trouble> troubles = robot.pass(3.0);
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_EQ(troubles[0].code, fault.code);
  EXPECT_EQ(troubles[0].subject, fault.subject);
  EXPECT_THAT(troubles[0].text, HasSubstr(fault.text));
  EXPECT_THAT(troubles[0].remedy, HasSubstr(fault.remedy));
  EXPECT_GE(troubles[0].since_utime, before - 1'000'000);
  EXPECT_LE(troubles[0].since_utime, before + 1'100'000);

  fault.mend(robot);
  const auto is_gone = [](const std::vector<Trouble>& present) { return present.empty(); };
  EXPECT_LE(robot.until(is_gone, 10.0), 2.0 + 1e-6);
  EXPECT_TRUE(robot.pass(5.0).empty());
}

INSTANTIATE_TEST_SUITE_P(Faults, EveryTrouble, ::testing::Range<std::size_t>(0, 14),
                         [](const auto& fault) { return std::string(name_of(faults()[fault.param].code)); });

TEST(TroubleOrder, RanksEveryCodeOnceAndIsTheOrderOfTheCodes) {
  std::set<std::string> names;
  int expected = 0;
  for (const TroubleRank& rank : kTroubleOrder) {
    EXPECT_EQ(static_cast<int>(rank.code), expected++);
    EXPECT_TRUE(names.insert(rank.name).second) << rank.name;
    EXPECT_STRNE(rank.why, "");
  }
  EXPECT_EQ(names, (std::set<std::string>{"mmi_lost", "process_dead", "process_hung", "camera_silent", "mark_unseen",
                                          "hand_unseen", "stop_latched", "stop_device_silent", "pose_lost",
                                          "base_blocked", "second_writer", "messages_lost", "clock_ahead",
                                          "recording_ended", "target_refused"}));
}

TEST(TroubleOrder, AllButThePagesOwnAreTestedAbove) {
  std::set<TroubleCode> codes{TroubleCode::kMmiLost};
  for (const Fault& fault : faults()) codes.insert(fault.code);
  EXPECT_EQ(codes.size(), std::size(kTroubleOrder));
}

TEST(TroubleOrder, TheWorstIsTheFirstWhateverBeganFirst) {
  HealthyRobot robot;
  robot.pass(5.0);
  for (std::size_t i = faults().size(); i-- > 0;) {
    const bool excludes_others =
        faults()[i].code == TroubleCode::kTargetRefused || faults()[i].code == TroubleCode::kCameraSilent ||
        faults()[i].code == TroubleCode::kStopDeviceSilent || faults()[i].code == TroubleCode::kProcessHung;
    if (!excludes_others) faults()[i].begin(robot);
  }
  std::vector<TroubleCode> codes;
  for (const Trouble& trouble : robot.pass(3.0)) codes.push_back(trouble.code);
  EXPECT_EQ(codes,
            (std::vector<TroubleCode>{TroubleCode::kSecondWriter, TroubleCode::kProcessDead, TroubleCode::kClockAhead,
                                      TroubleCode::kMessagesLost, TroubleCode::kStopLatched, TroubleCode::kMarkUnseen,
                                      TroubleCode::kHandUnseen, TroubleCode::kPoseLost, TroubleCode::kBaseBlocked,
                                      TroubleCode::kRecordingEnded}));
}

}  // namespace
}  // namespace markservo::mmi
