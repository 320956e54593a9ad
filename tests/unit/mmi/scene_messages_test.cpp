#include "services/mmi/scene/scene_messages.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ProcessStatus.hpp>
#include <markservo/RecorderStatus.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <string>

#include "tests/unit/encoded.hpp"

namespace markservo::mmi {
namespace {

template <class M>
ReadReport read(const std::string& channel, const M& message) {
  const auto bytes = test::encoded(message);
  return read_report(channel, bytes.data(), bytes.size());
}

// The report of a message that keeps its rules.
template <class R, class M>
R report(const std::string& channel, M message) {
  message.session = 7;
  const ReadReport result = read(channel, message);
  EXPECT_EQ(result.bad, "");
  const auto* report = std::get_if<R>(&result.report);
  EXPECT_NE(report, nullptr);
  return report == nullptr ? R{} : *report;
}

JointState joints(const std::vector<double>& position) {
  JointState message{};
  message.session = 7;
  message.utime = 5;
  message.num_joints = static_cast<std::int32_t>(position.size());
  message.position = position;
  message.speed.resize(position.size());
  return message;
}

TEST(ReportOfAMessage, OfJointsIsMeasuredOrCommanded) {
  const auto measured = report<JointReport>("JOINT_STATE", joints({0.1, 0.2, -0.3}));
  EXPECT_FALSE(measured.commanded);
  EXPECT_EQ(measured.utime, 5);
  EXPECT_EQ(measured.q, robot::JointVector(0.1, 0.2, -0.3));
  JointCommand command{};
  command.num_joints = 3;
  command.position = {0.4, 0.5, -0.6};
  command.speed_limit = {1.0, 1.0, 1.0};
  const auto commanded = report<JointReport>("JOINT_COMMAND", command);
  EXPECT_TRUE(commanded.commanded);
  EXPECT_EQ(commanded.q, robot::JointVector(0.4, 0.5, -0.6));
}

TEST(ReportOfAMessage, OfTargetsHasEachMark) {
  TargetPose message{};
  message.utime = message.frame_utime = 9;
  message.frame_seq = 3;
  message.num_marks = 1;
  message.marks.resize(1);
  LocatedMark& mark = message.marks[0];
  mark.name = "hand";
  mark.role = LocatedMark::ROLE_MANIPULATOR;
  mark.status = LocatedMark::LOCATED;
  mark.cue = LocatedMark::CUE_OUTLINE;
  mark.p_C = {0.1, 0.3, -0.1};
  mark.covariance = {1e-6, 1e-8, 2e-8, 2e-6, 3e-8, 3e-6};
  mark.normal_C = {0.0, -1.0, 0.0};
  const auto targets = report<TargetReport>("TARGET_POSE", message);
  EXPECT_EQ(targets.utime, 9);
  EXPECT_EQ(targets.frame_seq, 3);
  ASSERT_EQ(targets.marks.size(), 1u);
  EXPECT_EQ(targets.marks[0].role, robot::MarkRole::kManipulator);
  EXPECT_EQ(targets.marks[0].status, MarkStatus::kLocated);
  EXPECT_EQ(targets.marks[0].cue, MarkCue::kOutline);
  EXPECT_EQ(targets.marks[0].p_C, Eigen::Vector3d(0.1, 0.3, -0.1));
  EXPECT_EQ(targets.marks[0].covariance_C(1, 2), 3e-8);
  EXPECT_EQ(targets.marks[0].covariance_C, targets.marks[0].covariance_C.transpose());
  EXPECT_EQ(targets.marks[0].normal_C.y(), -1.0);
}

TEST(ReportOfAMessage, OfAGoalSaysWhetherItIsBySight) {
  ServoGoal goal{};
  goal.kind = ServoGoal::SERVO;
  goal.target = "red_book";
  goal.p_TG_C = {0.0, 0.015, -0.05};
  const auto by_sight = report<ServoGoalReport>("SERVO_GOAL", goal);
  EXPECT_TRUE(by_sight.by_sight);
  EXPECT_EQ(by_sight.target, "red_book");
  EXPECT_EQ(by_sight.p_TG_C.y(), 0.015);
  goal.kind = ServoGoal::HOLD;
  EXPECT_FALSE(report<ServoGoalReport>("SERVO_GOAL", goal).by_sight);
}

TEST(ReportOfAMessage, OfARoundHasItsHits) {
  RfidTagHits hits{};
  hits.utime = hits.window_end = 30;
  hits.window_start = 20;
  hits.num_hits = 2;
  hits.hits.resize(2);
  hits.hits[0].uid = "E001";
  hits.hits[0].utime = 25;
  hits.hits[0].rssi = -40.0;
  hits.hits[0].rssi_known = 1;
  hits.hits[1].uid = "E002";
  hits.hits[1].utime = 26;
  const auto round = report<RoundReport>("RFID_TAG_HITS", hits);
  EXPECT_EQ(round.utime, 30);
  ASSERT_EQ(round.hits.size(), 2u);
  EXPECT_EQ(round.hits[0].rssi, -40.0);
  EXPECT_EQ(round.hits[0].utime, 25);
  EXPECT_FALSE(round.hits[1].rssi);
}

TEST(ReportOfAMessage, OfAPoseHasTheDelay) {
  RobotPose pose{};
  pose.utime = 4;
  pose.state = RobotPose::LOCALISED;
  pose.pose = {1.0, 2.0, 0.5};
  pose.covariance = {1e-4, 0.0, 0.0, 1e-4, 0.0, 1e-3};
  pose.delay = 0.19;
  const auto robot = report<PoseReport>("ROBOT_POSE", pose);
  EXPECT_EQ(robot.session, 7);
  EXPECT_EQ(robot.state, LocalisationState::kLocalised);
  EXPECT_EQ(robot.X_WR.heading, 0.5);
  EXPECT_EQ(robot.delay, 0.19);
}

TEST(ReportOfAMessage, OfStatesHasThemAsEnums) {
  TaskState task{};
  task.state = TaskState::DRIVE;
  task.attempt = 2;
  task.target = "red_book";
  task.reason = "why";
  EXPECT_EQ(report<TaskReport>("TASK_STATE", task).phase, TaskPhase::kDrive);
  EXPECT_EQ(report<TaskReport>("TASK_STATE", task).attempt, 2);
  ServoStatus servo{};
  servo.state = ServoStatus::LOST;
  servo.settled = 1;
  EXPECT_EQ(report<ServoReport>("SERVO_STATUS", servo).state, ServoState::kLost);
  EXPECT_TRUE(report<ServoReport>("SERVO_STATUS", servo).settled);
  BaseStatus base{};
  base.state = BaseStatus::BLOCKED;
  base.reason = "in the way";
  EXPECT_EQ(report<BaseReport>("BASE_STATUS", base).state, BaseState::kBlocked);
  EXPECT_EQ(report<BaseReport>("BASE_STATUS", base).reason, "in the way");
  StopState stop{};
  stop.device = "arm";
  stop.latched = 1;
  stop.request_session = 8;
  stop.request_id = 2;
  EXPECT_TRUE(report<StopReport>("STOP_STATE", stop).latched);
  EXPECT_EQ(report<StopReport>("STOP_STATE", stop).request_id, 2);
}

TEST(ReportOfAMessage, OfServicesProcessesAndRecordingsNamesThem) {
  ServiceStatus service{};
  service.name = "visual-servo";
  service.host = "robot";
  service.state = "ready";
  EXPECT_EQ(report<ServiceReport>("SERVICE_STATUS", service).name, "visual-servo");
  EXPECT_EQ(report<ServiceReport>("SERVICE_STATUS", service).session, 7);
  ProcessStatus process{};
  process.name = "simulator";
  process.host = "robot";
  process.state = ProcessStatus::FAILED;
  process.restarts = 3;
  EXPECT_EQ(report<ProcessReport>("PROCESS_STATUS", process).state, ProcessState::kFailed);
  EXPECT_EQ(report<ProcessReport>("PROCESS_STATUS", process).restarts, 3);
  RecorderStatus recorder{};
  recorder.folder = "/logs/a";
  recorder.host = "robot";
  recorder.recording = 1;
  recorder.parts = 2;
  EXPECT_TRUE(report<RecorderReport>("RECORDER_STATUS", recorder).recording);
  EXPECT_EQ(report<RecorderReport>("RECORDER_STATUS", recorder).parts, 2);
}

TEST(ReportOfAMessage, OfRequestsTellsStopFromReset) {
  StopRequest stop{};
  stop.session = 3;
  stop.request_id = 4;
  stop.kind = StopRequest::RESET;
  stop.source = "page";
  auto result = read("STOP", stop);
  EXPECT_TRUE(std::get<StopRequestReport>(result.report).reset);
  EXPECT_EQ(std::get<StopRequestReport>(result.report).source, "page");
  TaskCommand command{};
  command.session = 3;
  command.command_id = 5;
  command.kind = TaskCommand::HOME;
  result = read("TASK_COMMAND", command);
  EXPECT_EQ(std::get<CommandReport>(result.report).kind, CommandKind::kHome);
}

TEST(ReportOfAMessage, OfAStopThatBreaksRulesIsMadeAllTheSame) {
  StopRequest stop{};
  stop.session = 3;
  stop.utime = -5;
  stop.kind = StopRequest::STOP;
  stop.reason = "a\nforged line";
  auto result = read("STOP", stop);
  EXPECT_EQ(result.bad, "");
  EXPECT_EQ(std::get<StopRequestReport>(result.report).reason, "a forged line");
  stop.kind = StopRequest::RESET;
  result = read("STOP", stop);
  EXPECT_FALSE(result.bad.empty()) << "a RESET must keep them";
  EXPECT_TRUE(std::holds_alternative<std::monostate>(result.report));
}

TEST(ReportOfAMessage, IsRefusedWhereItIsImpossible) {
  EXPECT_FALSE(read("JOINT_STATE", joints({0.1, std::numeric_limits<double>::quiet_NaN(), 0.0})).bad.empty());
  EXPECT_NE(read("JOINT_STATE", joints({0.1, 0.2})).bad.find("allowed: 3"), std::string::npos);
  TaskState task{};
  task.session = 7;
  task.state = 99;
  EXPECT_FALSE(read("TASK_STATE", task).bad.empty());
  EXPECT_FALSE(read("TASK_STATE", joints({0.1, 0.2, 0.3})).bad.empty()) << "another type than the channel's";
  EXPECT_FALSE(read_report("TASK_STATE", "abc", 3).bad.empty());
  EXPECT_FALSE(read_report("TASK_STATE", nullptr, 0).bad.empty());
}

TEST(ReportOfAMessage, IsNoneOfWhatNoViewNeeds) {
  for (const char* channel : {"STEREO_FRAME", "NO_SUCH_CHANNEL", ""}) {
    const ReadReport result = read_report(channel, "abc", 3);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(result.report));
    EXPECT_EQ(result.bad, "");
  }
}

}  // namespace
}  // namespace markservo::mmi
