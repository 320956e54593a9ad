// Driving to the target first: when the base is told to drive, when to hold, and what ends a drive.

#include <gtest/gtest.h>

#include <algorithm>

#include "services/task-manager/inputs/base_reports.hpp"
#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

const geometry::PlanePose kDock{0.2, 1.05, M_PI / 2};

// A robot 1 m before the dock, from which the book is in the workspace's middle.
FakeRobot robot_before_the_dock() {
  FakeRobot robot;
  robot.p_CT.y() = 1.25;
  robot.run_for(0.5);
  return robot;
}

TEST(Drive, BringsTheRobotToTheDockAndThenTheBookIsTaken) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted)) << name_of(robot.last().phase) << ": " << robot.last().reason;
  EXPECT_EQ(std::vector<Phase>(robot.phases().begin(), robot.phases().begin() + 4),
            (std::vector<Phase>{Phase::kIdle, Phase::kDrive, Phase::kLook, Phase::kApproach}));
  EXPECT_NEAR(robot.base_pose.y, 1.05, 1e-9);
  EXPECT_NEAR(robot.way_of_base(), 1.0, 1e-6);
  EXPECT_EQ(robot.reckless(), "");
  EXPECT_EQ(robot.last().result, Result::kLifted);
}

TEST(Drive, SendsTheCommandedPoseInTheWorld) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kDrive, 1.0));
  robot.frame();
  const DriveGoal& goal = robot.drive_goal();
  EXPECT_TRUE(goal.drive);
  EXPECT_FALSE(goal.from_robot);
  EXPECT_EQ(goal.pose.x, 0.2);
  EXPECT_EQ(goal.pose.y, 1.05);
  EXPECT_EQ(goal.pose.heading, M_PI / 2);
  EXPECT_EQ(goal.clearance, DriveParameters().clearance);
  EXPECT_EQ(goal.speed, DriveParameters().speed);
  EXPECT_EQ(robot.last().reason, "driving to x 0.20 m, y 1.05 m, 90 degrees");
}

TEST(Drive, RepeatsItsGoalFiveTimesASecondUnderOneId) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  robot.run_for(0.2);
  const std::int64_t id = robot.drive_goal().id;
  const int before = robot.drive_goals_sent();
  robot.run_for(2.0);
  ASSERT_TRUE(robot.drive_goal().drive);
  EXPECT_EQ(robot.drive_goal().id, id);
  EXPECT_NEAR(robot.drive_goals_sent() - before, 9, 1);
}

TEST(Drive, HoldsTheBaseWithoutATaskAndWhileTheArmWorks) {
  FakeRobot robot;
  robot.frame();
  EXPECT_EQ(robot.drive_goals_sent(), 1) << "it comes up told to hold";
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
  const int before = robot.drive_goals_sent();
  robot.run_for(2.0);
  EXPECT_NEAR(robot.drive_goals_sent() - before, 9, 1);
  EXPECT_FALSE(robot.drive_goal().drive);
  EXPECT_EQ(robot.way_of_base(), 0.0);
}

TEST(Drive, HoldsTheBaseFromArrivalOn) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kLook));
  EXPECT_FALSE(robot.drive_goal().drive);
  robot.base_pose.y -= 0.05;  // pushed: a base that still had its goal would go back there
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
  EXPECT_EQ(robot.reckless(), "");
}

TEST(Drive, LooksOnlyAMomentAfterArrival) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  double arrived = 0.0;
  for (int i = 0; i < 300 && robot.last().phase != Phase::kLook; ++i) {
    robot.frame();
    if (robot.drive_goal().drive) arrived = robot.seconds();
  }
  ASSERT_EQ(robot.last().phase, Phase::kLook);
  ASSERT_GT(arrived, 0.0);
  EXPECT_GE(robot.seconds() - arrived, DriveParameters().settle_time - 1e-6);
}

TEST(Drive, FoldsTheArmFirst) {
  FakeRobot robot;
  robot.slips = 2;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kFailed));
  ASSERT_GT((robot.q() - default_robot().arm->home).norm(), 0.3) << "it is still stretched out";
  robot.base_pose.y = 0.85;
  robot.p_CT.y() = 0.45;
  robot.send_drive(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
  EXPECT_EQ(robot.reckless(), "");
  EXPECT_GT(robot.way_of_base(), 0.1);
}

TEST(Drive, StartIsRefusedWhileTheHandHoldsABook) {
  FakeRobot robot;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kHoldLifted));
  robot.send_drive(kDock);
  robot.run_for(2.0);
  EXPECT_EQ(robot.last().phase, Phase::kRefused);
  EXPECT_EQ(robot.way_of_base(), 0.0);
}

TEST(Drive, ARobotWithoutBaseRefusesToDriveAndTakesAsEver) {
  robot::RobotDescription description = default_robot();
  description.base.reset();
  FakeRobot robot(description);
  robot.send_drive(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kRefused, 1.0));
  EXPECT_EQ(robot.last().reason, "the robot cannot drive: its description has no section 'base'");
  robot.send(CommandKind::kStart, "red_book");
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
  EXPECT_EQ(robot.drive_goals_sent(), 0);
}

TEST(Drive, ABaseThatIsSilentDoesNotMatterWhereNothingIsToBeDriven) {
  FakeRobot robot;
  robot.base_answers = false;
  robot.send(CommandKind::kStart, "red_book");
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
}

TEST(Drive, WaitsForWhatBlocksTheWayAndGoesOn) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  robot.run_for(1.0);
  robot.base_stuck = BaseState::kBlocked;
  robot.run_for(15.0);
  EXPECT_EQ(robot.last().phase, Phase::kDrive);
  EXPECT_EQ(robot.last().reason, "driving to x 0.20 m, y 1.05 m, 90 degrees; something blocks the base's way");
  robot.base_stuck.reset();
  robot.run_for(0.1);
  EXPECT_EQ(robot.last().reason, "driving to x 0.20 m, y 1.05 m, 90 degrees");
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
}

// The reason why a drive that base-navigator answers with `state` fails, and how long that takes.
std::pair<std::string, double> failure_of(BaseState state) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  robot.run_for(1.0);
  robot.base_stuck = state;
  robot.base_reason = "why";
  const double begin = robot.seconds();
  while (robot.last().phase == Phase::kDrive && robot.seconds() < begin + 200.0) robot.frame();
  const double end = robot.seconds();
  EXPECT_FALSE(robot.drive_goal().drive) << "told to hold";
  EXPECT_EQ(robot.last().result, Result::kFailed);
  EXPECT_EQ(robot.last().phase, state == BaseState::kStopped ? Phase::kStopped : Phase::kFailed);
  return {robot.last().reason, end - begin};
}

TEST(Drive, FailsWithTheNavigatorsReasonWhenTheWayStaysBlocked) {
  const auto [reason, seconds] = failure_of(BaseState::kBlocked);
  EXPECT_EQ(reason, "something blocks the base's way: why");
  EXPECT_NEAR(seconds, 20.0, 0.2);
}

TEST(Drive, FailsWhenTheBaseStaysLost) {
  const auto [reason, seconds] = failure_of(BaseState::kLost);
  EXPECT_EQ(reason, "the base does not know where it is: why");
  EXPECT_NEAR(seconds, 20.0, 0.2);
}

TEST(Drive, FailsAtOnceWhenTheNavigatorRefusesTheGoal) {
  const auto [reason, seconds] = failure_of(BaseState::kHold);
  EXPECT_EQ(reason, "base-navigator refuses the goal: why");
  EXPECT_LT(seconds, 0.2);
}

TEST(Drive, FailsWhenTheNavigatorsInputStaysStale) {
  const auto [reason, seconds] = failure_of(BaseState::kStale);
  EXPECT_EQ(reason, "the base holds for want of fresh input: why");
  EXPECT_NEAR(seconds, 2.0, 0.2);
}

TEST(Drive, StopsWhenTheNavigatorObeysAStop) {
  const auto [reason, seconds] = failure_of(BaseState::kStopped);
  EXPECT_EQ(reason, "base-navigator is stopped: why");
  EXPECT_NEAR(seconds, 2.0, 0.2);
}

TEST(Drive, FailsWhenTheNavigatorFallsSilent) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  robot.run_for(1.0);
  robot.base_answers = false;
  const double begin = robot.seconds();
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 10.0));
  EXPECT_EQ(robot.last().reason, "base-navigator does not answer: no BASE_STATUS of this goal within 2.0 s");
  EXPECT_LT(robot.seconds() - begin, 4.5);
  EXPECT_FALSE(robot.drive_goal().drive);
}

TEST(Drive, FailsWhenNoNavigatorEverAnswers) {
  FakeRobot robot;
  robot.base_answers = false;
  robot.send_drive(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 5.0));
  EXPECT_EQ(robot.last().reason, "base-navigator does not answer: no BASE_STATUS of this goal within 2.0 s");
}

TEST(Drive, ARestartedNavigatorGoesOn) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  robot.run_for(1.0);
  robot.base_stuck = BaseState::kStale;
  robot.run_for(1.8);
  robot.base_stuck.reset();
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
}

TEST(Drive, FailsWhenItTakesTooLong) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  robot.run_for(1.0);
  robot.base_stuck = BaseState::kDriving;  // on the spot
  ASSERT_TRUE(robot.run_until(Phase::kFailed, 130.0));
  EXPECT_EQ(robot.last().reason, "the base did not arrive within 120.0 s");
}

TEST(Drive, AnotherGoalsArrivalIsNotOurs) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  while (robot.last().reason != "arrived" && robot.seconds() < 20.0) robot.frame();
  robot.base_answers = false;  // that was its last word
  robot.send(CommandKind::kAbort);
  robot.frame();
  robot.send_drive({0.2, 0.05, M_PI / 2});
  robot.run_for(1.0);
  EXPECT_EQ(robot.last().phase, Phase::kDrive);
  EXPECT_TRUE(robot.drive_goal().drive);
}

TEST(Drive, AbortAndStopHoldTheBaseAtOnce) {
  for (const bool by_stop : {false, true}) {
    FakeRobot robot = robot_before_the_dock();
    robot.send_drive(kDock);
    robot.run_for(1.0);
    ASSERT_GT(robot.way_of_base(), 0.1);
    if (by_stop) robot.stop = {true, true, "arm: by a person"};
    if (!by_stop) robot.send(CommandKind::kAbort);
    const Output output = robot.frame();
    EXPECT_EQ(output.phase, Phase::kStopped);
    ASSERT_TRUE(output.drive_goal);
    EXPECT_FALSE(output.drive_goal->drive);
    robot.stop = {true, false, ""};
    const double way = robot.way_of_base();
    robot.run_for(3.0);
    EXPECT_EQ(robot.way_of_base(), way);
  }
}

TEST(Drive, ARestartedTaskManagerHoldsTheBaseAndKnowsNoTask) {
  FakeRobot robot = robot_before_the_dock();
  robot.send_drive(kDock);
  robot.run_for(1.0);
  robot.restart_task_manager();
  const Output output = robot.frame();
  EXPECT_EQ(output.phase, Phase::kIdle);
  ASSERT_TRUE(output.drive_goal);
  EXPECT_FALSE(output.drive_goal->drive);
}

TEST(Drive, WaitsForTheFirstWordOfTheStopDevicesBeforeItMoves) {
  FakeRobot robot;
  robot.stop.known = false;
  robot.stop.silent = "arm";
  robot.send_drive(kDock);
  robot.run_for(1.0);
  EXPECT_EQ(robot.last().phase, Phase::kDrive);
  EXPECT_FALSE(robot.drive_goal().drive);
  ASSERT_TRUE(robot.run_until(Phase::kRefused, 10.0));
  EXPECT_EQ(robot.last().reason, "not every stop device answers: no STOP_STATE of arm");
  EXPECT_EQ(robot.way_of_base(), 0.0);
}

TEST(Drive, ATargetThatIsNotSeenFromTheDockFailsTheTask) {
  FakeRobot robot = robot_before_the_dock();
  robot.target_sight = Sight::kUnseen;
  robot.send_drive(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kFailed));
  EXPECT_EQ(robot.last().reason, "after the drive: out_of_view: the mark of red_book is seen by neither camera");
  EXPECT_FALSE(robot.drive_goal().drive);
}

TEST(Correction, BringsATargetThatIsOutOfReachIntoTheMiddleOfTheWorkspace) {
  FakeRobot robot = robot_before_the_dock();
  robot.p_CT.x() += 0.02;
  robot.base_drift = 0.10;  // the book is then 35 cm away
  robot.send_drive(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kApproach)) << robot.last().reason;
  EXPECT_EQ(std::count(robot.phases().begin(), robot.phases().end(), Phase::kDrive), 2);
  EXPECT_NEAR(robot.p_CT.x(), 0.0325, 1e-6);
  EXPECT_NEAR(robot.p_CT.y(), 0.25, 1e-6);
  EXPECT_TRUE(robot.run_until(Phase::kHoldLifted)) << robot.last().reason;
  EXPECT_EQ(robot.reckless(), "");
}

TEST(Correction, IsTriedTwiceAndNoMore) {
  FakeRobot robot = robot_before_the_dock();
  robot.base_drift = 0.10;
  robot.send_drive(kDock);
  int drives = 0;
  Phase before = Phase::kIdle;
  for (int i = 0; i < 3000 && (under_way(robot.last().phase) || drives == 0); ++i) {
    if (robot.frame().phase == Phase::kDrive && before != Phase::kDrive) {
      ++drives;
      if (drives > 1) robot.p_CT.y() += 0.10;  // what is seen is never where it was driven to
    }
    before = robot.last().phase;
  }
  EXPECT_EQ(drives, 3);
  EXPECT_EQ(robot.last().phase, Phase::kFailed);
  EXPECT_EQ(robot.last().reason.rfind("after the drive: unreachable: ", 0), 0u) << robot.last().reason;
}

TEST(Correction, IsNotTriedForATaskThatDidNotDrive) {
  FakeRobot robot;
  robot.p_CT.y() = 0.40;
  robot.send(CommandKind::kStart, "red_book");
  ASSERT_TRUE(robot.run_until(Phase::kRefused));
  EXPECT_EQ(robot.way_of_base(), 0.0);
}

TEST(Correction, IsNotTriedOverADistanceThatNoDockIsOffBy) {
  FakeRobot robot = robot_before_the_dock();
  robot.base_drift = 0.50;
  robot.send_drive(kDock);
  ASSERT_TRUE(robot.run_until(Phase::kFailed)) << name_of(robot.last().phase);
  EXPECT_EQ(std::count(robot.phases().begin(), robot.phases().end(), Phase::kDrive), 1);
}

TEST(BaseReports, GiveTheNewestFromBeforeAFrame) {
  BaseReports reports;
  EXPECT_FALSE(reports.before(1'000'000));
  for (const std::int64_t utime : {100, 200, 300}) {
    BaseReport report;
    report.utime = utime;
    reports.add(report);
  }
  EXPECT_FALSE(reports.before(100));
  EXPECT_EQ(reports.before(200)->utime, 100);
  EXPECT_EQ(reports.before(250)->utime, 200);
  EXPECT_EQ(reports.before(1'000'000)->utime, 300);
}

TEST(BaseReports, ForgetAnotherWorld) {
  BaseReports reports;
  BaseReport report;
  report.utime = 5'000;
  reports.add(report);
  report.utime = 100;
  reports.add(report);
  EXPECT_EQ(reports.before(10'000)->utime, 100);
}

}  // namespace
}  // namespace markservo::task_manager
