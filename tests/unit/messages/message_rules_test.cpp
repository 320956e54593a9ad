// The rules of what cameras, arm and tasks say to each other.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <markservo/JointCommand.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/ProcessStatus.hpp>
#include <markservo/RecorderStatus.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskState.hpp>

#include "tests/unit/messages/violation.hpp"

namespace markservo::messages {
namespace {

StereoFrame small_frame() {
  StereoFrame frame{};
  frame.calibration.fx = frame.calibration.fy = 784.0;
  frame.calibration.baseline = 0.065;
  frame.width = 4;
  frame.height = 2;
  frame.left_size = frame.right_size = 24;
  frame.left.resize(24);
  frame.right.resize(24);
  return frame;
}

TEST(StereoFrameRules, AcceptAWholeFrame) {
  EXPECT_EQ(violation(small_frame()), "");
}

TEST(StereoFrameRules, RefuseImagesOfDifferentSizes) {
  auto frame = small_frame();
  frame.right_size = 12;
  frame.right.resize(12);
  EXPECT_NE(violation(frame).find("right_size"), std::string::npos);
}

TEST(StereoFrameRules, RefuseImpossibleSizesAndCalibrations) {
  for (const std::int32_t width : {0, -4, 1000000}) {
    auto frame = small_frame();
    frame.width = width;
    EXPECT_NE(violation(frame).find("width"), std::string::npos);
  }
  for (const double baseline : {0.0, -0.065, 65.0, std::nan("")}) {
    auto frame = small_frame();
    frame.calibration.baseline = baseline;
    const char* field = std::isnan(baseline) ? "calibration is not finite" : "calibration.baseline is ";
    EXPECT_EQ(violation(frame).rfind(field, 0), 0U) << violation(frame);
  }
  auto frame = small_frame();
  frame.encoding = 9;
  EXPECT_NE(violation(frame).find("encoding"), std::string::npos);
}

// What a small message can make a reader decode.
TEST(StereoFrameRules, RefuseMorePixelsThanAVideoCameraHas) {
  auto frame = small_frame();
  frame.encoding = StereoFrame::ENCODING_JPEG;
  frame.width = 4096;
  frame.height = 3072;
  EXPECT_EQ(violation(frame), "");
  frame.width = 16384;
  frame.height = 16384;
  EXPECT_NE(violation(frame).find("width * height"), std::string::npos);
}

TEST(JointCommandRules, RefuseWhatAnArmMustNotTry) {
  JointCommand command{};
  command.num_joints = 1;
  command.position = {0.1};
  command.speed_limit = {1.0};
  EXPECT_EQ(violation(command), "");
  command.speed_limit = {0.0};
  EXPECT_NE(violation(command).find("speed_limit"), std::string::npos);
  command.speed_limit = {1.0};
  command.position = {INFINITY};
  EXPECT_EQ(violation(command), "a joint's value is not finite; allowed: finite numbers");
  command.position = {0.1};
  command.gripper_opening = -0.01;
  EXPECT_NE(violation(command).find("gripper_opening"), std::string::npos);
}

TEST(TargetPoseRules, RefuseAPositionThatIsNotANumberAndANegativeVariance) {
  TargetPose pose{};
  pose.num_marks = 1;
  pose.marks.resize(1);
  EXPECT_EQ(violation(pose), "");
  pose.marks[0].name = "red_book";
  pose.marks[0].p_C.y = std::nan("");
  EXPECT_EQ(violation(pose), "mark red_book: p_C is nan; allowed: -10000 to 10000 m");
  pose.marks[0].p_C.y = 0.3;
  pose.marks[0].covariance.yy = -1.0;
  EXPECT_NE(violation(pose).find("covariance"), std::string::npos);
}

TEST(MarkDetectionRules, RefuseAPatchWhosePixelsAreNotAllThere) {
  MarkDetection detection{};
  detection.width = 640;
  detection.height = 480;
  detection.calibration.fx = detection.calibration.fy = 784.0;
  detection.calibration.baseline = 0.065;
  detection.num_marks = 1;
  detection.marks.resize(1);
  auto& patch = detection.marks[0].left.patch;
  patch.scale = 1;
  patch.width = 9;
  patch.height = 2;
  patch.bgr_size = 54;
  patch.bgr.resize(54);
  patch.mask_size = 4;
  patch.mask.resize(4);
  EXPECT_EQ(violation(detection), "");
  patch.width = 10;
  EXPECT_NE(violation(detection).find("bgr_size"), std::string::npos);
}

SonarScan sonar_scan() {
  SonarScan scan{};
  scan.min_range = 0.1;
  scan.max_range = 5.0;
  scan.beam_width = 0.5;
  return scan;
}

TEST(SonarScanRules, AcceptAnOrdinaryScan) {
  EXPECT_EQ(violation(sonar_scan()), "");
}

TEST(SonarScanRules, RefuseRangesThatNoSonarHas) {
  auto scan = sonar_scan();
  scan.min_range = 9000.0;
  scan.max_range = 10'000.0;
  EXPECT_NE(violation(scan).find("is 10000;"), std::string::npos) << violation(scan);
  EXPECT_NE(violation(scan).find("up to 100 m"), std::string::npos) << violation(scan);
}

TEST(SonarScanRules, NameTheRangeThatIsRefused) {
  auto scan = sonar_scan();
  scan.min_range = -0.1;
  EXPECT_EQ(violation(scan), "min_range is -0.1; allowed: 0 m or more");
  scan.min_range = scan.max_range;
  EXPECT_EQ(violation(scan), "max_range is 5; allowed: above min_range, up to 100 m");
}

TEST(SonarScanRules, RefuseABeamWiderThanAWholeTurn) {
  auto scan = sonar_scan();
  scan.beam_width = 6.5;
  EXPECT_NE(violation(scan).find("beam_width"), std::string::npos) << violation(scan);
}

TEST(ServoGoalRules, NameTheValueThatIsRefused) {
  ServoGoal goal{};
  goal.tolerance = 0.004;
  EXPECT_EQ(violation(goal), "");
  goal.speed = -0.25;
  EXPECT_EQ(violation(goal), "speed is -0.25; allowed: 0 m/s or more");
  goal.speed = 0.0;
  goal.tolerance = -1.0;
  EXPECT_EQ(violation(goal), "tolerance is -1; allowed: 0 m or more");
}

TEST(MarkDetectionRules, NameTheSizeThatIsRefused) {
  MarkDetection detection{};
  detection.width = 640;
  detection.height = 480;
  detection.calibration.fx = detection.calibration.fy = 784.0;
  detection.calibration.baseline = 0.065;
  detection.marks.resize(1);
  detection.marks[0].left.seen = 1;
  detection.marks[0].left.width = 12;
  detection.marks[0].left.height = -3;
  EXPECT_NE(violation(detection).find("view.height is -3;"), std::string::npos) << violation(detection);
}

TEST(StateRules, RefuseStatesThatAreNotNumbered) {
  TaskState task{};
  for (const std::int8_t state : {TaskState::IDLE, TaskState::DRIVE}) {
    task.state = static_cast<std::int8_t>(state);
    EXPECT_EQ(violation(task), "");
  }
  for (const int state : {-1, TaskState::DRIVE + 1}) {
    task.state = static_cast<std::int8_t>(state);
    EXPECT_NE(violation(task).find("state"), std::string::npos);
  }
  task.state = 0;
  task.result = TaskState::RESULT_FAILED + 1;
  EXPECT_NE(violation(task).find("result"), std::string::npos);
  ServoStatus servo{};
  servo.state = ServoStatus::STOPPED + 1;
  EXPECT_NE(violation(servo).find("state"), std::string::npos);
  TargetPose pose{};
  pose.marks.resize(1);
  pose.marks[0].status = LocatedMark::INCONSISTENT + 1;
  EXPECT_NE(violation(pose).find("status"), std::string::npos);
  pose.marks[0].status = 0;
  pose.marks[0].cue = LocatedMark::CUE_CENTROID;
  EXPECT_EQ(violation(pose), "");
  pose.marks[0].cue = LocatedMark::CUE_CENTROID + 1;
  EXPECT_NE(violation(pose).find("cue"), std::string::npos);
  pose.marks[0].cue = 0;
  pose.marks[0].role = 2;
  EXPECT_NE(violation(pose).find("role"), std::string::npos);
}

TEST(TruthAndDisplayRules, RefuseWhatIsNotANumber) {
  SimTruth truth{};
  EXPECT_EQ(violation(truth), "");
  truth.p_CG.y = NAN;
  EXPECT_NE(violation(truth).find("p_CG"), std::string::npos);
  StereoMatches matches{};
  matches.marks.resize(1);
  matches.marks[0].residual = {0.1, INFINITY};
  EXPECT_NE(violation(matches).find("match"), std::string::npos);
  ServiceStatus status{};
  status.channels.resize(1);
  status.channels[0].latency_p99 = NAN;
  EXPECT_NE(violation(status).find("latency"), std::string::npos);
  status.channels[0].latency_p99 = 0.0;
  status.channels[0].lost = -1;
  EXPECT_NE(violation(status).find("is -1;"), std::string::npos);
}

TEST(StackRules, RefuseProcessesAndRecordingsThatCannotBe) {
  ProcessStatus process{};
  process.state = ProcessStatus::FAILED;
  process.pid = 7;
  EXPECT_EQ(violation(process), "");
  process.state = ProcessStatus::FAILED + 1;
  EXPECT_EQ(violation(process), "state is 7; allowed: 0 to 6");
  process.state = ProcessStatus::RUNNING;
  process.pid = -1;
  EXPECT_EQ(violation(process), "pid is -1; allowed: 0 or more");
  process.pid = 7;
  process.restarts = -1;
  EXPECT_NE(violation(process).find("restarts"), std::string::npos);
  RecorderStatus recorder{};
  EXPECT_EQ(violation(recorder), "");
  recorder.free_bytes = -5;
  EXPECT_EQ(violation(recorder), "free_bytes is -5; allowed: 0 or more");
}

}  // namespace
}  // namespace markservo::messages
