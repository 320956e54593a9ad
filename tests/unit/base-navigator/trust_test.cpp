// What it does not drive by: old, lost or impossible input, and after a stop.

#include <gtest/gtest.h>

#include "tests/unit/base-navigator/rig.hpp"

namespace markservo::base_navigator::test {
namespace {

using geometry::PlanePose;

constexpr double kForever = std::numeric_limits<double>::infinity();

class UnderWay : public testing::Test {
 protected:
  UnderWay() {
    rig_.tell(Rig::goal_at({8.0, 0.0, 0.0}));
    rig_.run(3.0);
    EXPECT_GT(rig_.world.speed, 0.4);
  }

  // It is told to stand within 0.3 s, and says why with `word`.
  void expect_stale(const std::string& word, double within = 0.3) {
    EXPECT_LE(rig_.run_until(DriveState::kStale, 2.0), within);
    EXPECT_NE(rig_.last.status.reason.find(word), std::string::npos) << rig_.last.status.reason;
    EXPECT_EQ(rig_.last.command.speed, 0.0);
    EXPECT_EQ(rig_.last.command.turn_rate, 0.0);
    rig_.run(1.0);
    EXPECT_EQ(rig_.world.speed, 0.0);
  }

  void expect_driving_again() {
    rig_.run(3.0);
    EXPECT_EQ(rig_.last.status.state, DriveState::kDriving) << rig_.last.status.reason;
    EXPECT_GT(rig_.world.speed, 0.4);
  }

  Rig rig_{9};
};

TEST_F(UnderWay, StandsWithin300MillisecondsOfTheLastPose) {
  rig_.localiser_lives = false;
  expect_stale("ROBOT_POSE");
  rig_.localiser_lives = true;
  expect_driving_again();
}

TEST_F(UnderWay, StandsWithin300MillisecondsOfTheLastScan) {
  while (!rig_.world.scan_due()) rig_.step();
  rig_.step();
  rig_.sonars_live = false;
  expect_stale("SONAR_SCAN");
  rig_.sonars_live = true;
  expect_driving_again();
}

TEST_F(UnderWay, StandsWhenItsGoalIsNotRepeated) {
  rig_.sender_lives = false;
  expect_stale("BASE_GOAL", 0.9);  // 0.6 s of age after the last repetition
  rig_.sender_lives = true;
  expect_driving_again();
}

TEST_F(UnderWay, StandsWhileOdometryGoesBackInTime) {
  OdometrySample late = rig_.world.odometry();
  late.utime -= 1'000'000;
  EXPECT_NE(rig_.navigator.observe(late, rig_.state), "");
  const Output output = rig_.navigator.step(rig_.state);
  EXPECT_EQ(output.status.state, DriveState::kStale);
  EXPECT_EQ(output.command.speed, 0.0);
  expect_driving_again();
}

TEST_F(UnderWay, FollowsANewWritersGoalAfterTheClockWentBack) {
  rig_.world.utime -= 600'000'000;
  rig_.navigator.begin_anew("the clock of WHEEL_ODOMETRY was set back", rig_.state);
  Goal goal = Rig::goal_at({8.0, 0.0, 0.0});
  goal.session = 6;
  rig_.tell(goal);
  rig_.run(1.0);
  EXPECT_EQ(rig_.last.status.state, DriveState::kHold) << "it came while the former sender's word was young";
  goal.id = 2;
  rig_.tell(goal);
  expect_driving_again();
  EXPECT_EQ(rig_.last.status.goal_session, 6);
}

TEST_F(UnderWay, AClockThatWentBackEndsTheGoalFromBefore) {
  rig_.sender_lives = false;
  rig_.world.utime -= 600'000'000;
  rig_.navigator.begin_anew("the clock of WHEEL_ODOMETRY was set back", rig_.state);
  rig_.run(1.0);
  EXPECT_EQ(rig_.last.status.state, DriveState::kHold);
  EXPECT_EQ(rig_.last.status.reason, "the clock of WHEEL_ODOMETRY was set back: the goal was dropped");
  EXPECT_EQ(rig_.last.status.goal_id, 0);
  EXPECT_EQ(rig_.world.speed, 0.0);
}

TEST_F(UnderWay, StandsUntilAFreshScanAfterAJumpOfACounter) {
  while (!rig_.world.scan_due()) rig_.step();
  rig_.step();
  OdometrySample jumped = rig_.world.odometry();
  jumped.utime += 1'000;
  jumped.left += 8.3;
  EXPECT_NE(rig_.navigator.observe(jumped, rig_.state), "");
  Output output = rig_.navigator.step(rig_.state);
  EXPECT_EQ(output.status.state, DriveState::kStale);
  EXPECT_NE(output.status.reason.find("a wheel went"), std::string::npos) << output.status.reason;
  EXPECT_EQ(output.command.speed, 0.0);
  expect_driving_again();
}

TEST_F(UnderWay, RefusesScansOfAnotherRing) {
  SonarScanSample scan = rig_.world.scan();
  scan.readings.pop_back();
  const std::string problem = rig_.navigator.observe(scan, rig_.state);
  EXPECT_NE(problem.find("15 sonars"), std::string::npos) << problem;
  EXPECT_NE(problem.find("allowed: 16"), std::string::npos) << problem;
}

TEST_F(UnderWay, RefusesScansOfOtherSonarsThanRobotYamls) {
  const auto problem_of = [this](double min_range, double max_range, double beam_width) {
    SonarScanSample scan = rig_.world.scan();
    scan.min_range = min_range;
    scan.max_range = max_range;
    scan.beam_width = beam_width;
    return rig_.navigator.observe(scan, rig_.state);
  };
  EXPECT_NE(problem_of(4.9, 5.0, 0.52).find("min_range is 4.900 m; allowed: 0.050 to 0.200"), std::string::npos);
  EXPECT_NE(problem_of(0.1, 0.3, 0.52).find("max_range is 0.300 m; allowed: 2.500 to 10.000"), std::string::npos);
  EXPECT_NE(problem_of(0.1, 5.0, 6.28).find("beam_width is 6.280 rad; allowed: 0.262 to 1.047"), std::string::npos);
  EXPECT_NE(problem_of(0.1, 5.0, 0.01).find("beam_width"), std::string::npos);
  EXPECT_EQ(problem_of(0.1, 5.0, 0.52), "");
}

TEST_F(UnderWay, NamesTheSonarThatStandsOutsideTheRing) {
  SonarScanSample scan = rig_.world.scan();
  scan.readings[3].X_RS = {1.5, 0.0, 0.0};
  const std::string problem = rig_.navigator.observe(scan, rig_.state);
  EXPECT_NE(problem.find("sonar 3 is 1.50 m"), std::string::npos) << problem;
  EXPECT_NE(problem.find("allowed: 0.27 m"), std::string::npos) << problem;
}

TEST_F(UnderWay, StopsWhenItIsLostAndGoesOnWhenItIsNot) {
  rig_.world.localisation = Localisation::kLost;
  rig_.step();
  EXPECT_EQ(rig_.last.status.state, DriveState::kLost);
  rig_.run(1.0);
  EXPECT_EQ(rig_.world.speed, 0.0);
  rig_.world.localisation = Localisation::kLocalised;
  expect_driving_again();
}

TEST_F(UnderWay, APoseOfLargeSigmaIsALostOne) {
  rig_.world.position_sigma = 0.2;
  rig_.run(1.0);
  EXPECT_EQ(rig_.last.status.state, DriveState::kLost);
  EXPECT_NE(rig_.last.status.reason.find("m; allowed: 0.10 m"), std::string::npos) << rig_.last.status.reason;
  EXPECT_EQ(rig_.world.speed, 0.0);
}

TEST_F(UnderWay, AStopEndsTheGoalAndAResetDoesNotResumeIt) {
  rig_.navigator.observe_stop(true, "a hand", rig_.state);
  rig_.step();
  EXPECT_EQ(rig_.last.status.state, DriveState::kStopped);
  EXPECT_EQ(rig_.last.status.reason, "a hand");
  EXPECT_EQ(rig_.last.command.speed, 0.0);
  rig_.run(2.0);
  rig_.navigator.observe_stop(false, "", rig_.state);
  const PlanePose stood = rig_.world.X_WR;
  rig_.run(3.0);
  EXPECT_EQ(rig_.last.status.state, DriveState::kHold);
  EXPECT_LT((stood.inverse() * rig_.world.X_WR).distance(), 1e-9);
  rig_.tell(Rig::goal_at({8.0, 0.0, 0.0}, 0.0, 2));
  expect_driving_again();
}

TEST(Trust, AGoalGivenWhileStoppedIsNotDrivenAfterTheReset) {
  Rig rig;
  rig.navigator.observe_stop(true, "", rig.state);
  rig.tell(Rig::goal_at({2.0, 0.0, 0.0}));
  rig.run(1.0);
  rig.navigator.observe_stop(false, "", rig.state);
  rig.run(2.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kHold);
  EXPECT_EQ(rig.fastest, 0.0);
}

TEST(Trust, ARestartedNavigatorGoesOn) {
  Rig rig;
  rig.tell(Rig::goal_at({8.0, 0.0, 0.0}));
  rig.run(2.0);
  rig.state = NavigatorState();  // as a new process; STOP_STATE comes with the next repetition
  rig.run(0.2);
  EXPECT_EQ(rig.last.status.state, DriveState::kStopped);
  EXPECT_NE(rig.last.status.reason.find("STOP_STATE"), std::string::npos);
  rig.navigator.observe_stop(false, "", rig.state);
  rig.run(1.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kDriving) << rig.last.status.reason;
}

TEST(Trust, ImpossibleGoalsAreNamedAndNotDriven) {
  const auto reason_of = [](Goal goal) {
    Rig rig;
    rig.run(0.5);
    rig.tell(goal);
    rig.run(1.0);
    EXPECT_EQ(rig.last.status.state, DriveState::kHold);
    EXPECT_EQ(rig.last.status.goal_id, 1);
    EXPECT_EQ(rig.fastest, 0.0);
    return rig.last.status.reason;
  };
  EXPECT_NE(reason_of(Rig::goal_at({1e4, 0.0, 0.0})).find("10000 m away; allowed: 100 m"), std::string::npos);
  EXPECT_NE(reason_of(Rig::goal_at({1.0, 0.0, 0.0}, -0.1)).find("clearance"), std::string::npos);
  Goal far = Rig::goal_at({1e4, 0.0, 0.0});
  far.frame = GoalFrame::kRobot;
  EXPECT_NE(reason_of(far).find("away"), std::string::npos);
}

TEST(Trust, StaysWhileItIsSearchingWithoutAPose) {
  Rig rig;
  rig.world.localisation = Localisation::kSearching;
  rig.world.position_sigma = 100.0;
  rig.world.heading_sigma = 3.0;
  rig.tell(Rig::goal_at({2.0, 0.0, 0.0}));
  rig.run(5.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kLost);
  EXPECT_EQ(rig.fastest, 0.0);
}

TEST(Trust, AGoalOfTheFutureHeardBeforeTheFirstOdometryDoesNotWaitForItsHour) {
  Rig rig;
  Goal goal = Rig::goal_at({2.0, 0.0, 0.0});
  goal.utime = rig.world.utime + 2'000'000;
  rig.navigator.observe(goal, rig.state);
  rig.run(4.0);
  EXPECT_EQ(rig.fastest, 0.0);
  EXPECT_EQ(rig.last.status.reason,
            "the goal heard before the first WHEEL_ODOMETRY is of another time: it was dropped");
}

TEST(Explore, LearnsTheHeadingByCreepingAheadAndThenDrives) {
  Rig rig;
  rig.world.heading_sigma = 1.8;
  rig.tell(Rig::goal_at({2.0, 0.0, 0.0}));
  rig.run(2.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kDriving);
  EXPECT_EQ(rig.last.status.reason, "learning the heading");
  EXPECT_NEAR(rig.fastest, 0.1, 1e-9);
  EXPECT_EQ(rig.fastest_turn, 0.0);
  rig.world.heading_sigma = 0.05;
  EXPECT_LT(rig.run_until(DriveState::kArrived, 40.0), kForever);
}

TEST(Explore, StopsAfterItsWayWhenTheHeadingStaysUnknown) {
  Rig rig;
  rig.world.heading_sigma = 1.8;
  rig.tell(Rig::goal_at({2.0, 0.0, 0.0}));
  rig.run(30.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kLost);
  EXPECT_NE(rig.last.status.reason.find("heading"), std::string::npos);
  EXPECT_NEAR(rig.world.X_WR.x, 0.41, 0.03);
  EXPECT_EQ(rig.world.speed, 0.0);
}

TEST(Explore, GoesBackWhenSomethingStandsAhead) {
  Rig rig;
  rig.world.walls = {{{0.40, -0.5}, {0.40, 0.5}}};
  rig.world.heading_sigma = 1.8;
  rig.tell(Rig::goal_at({-2.0, 0.0, 0.0}));
  rig.run(3.0);
  EXPECT_LT(rig.world.X_WR.x, -0.1);
}

TEST(Explore, CanBeSwitchedOff) {
  NavigatorParameters parameters;
  parameters.explore.enabled = false;
  Rig rig(1, parameters);
  rig.world.heading_sigma = 1.8;
  rig.tell(Rig::goal_at({2.0, 0.0, 0.0}));
  rig.run(2.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kLost);
  EXPECT_EQ(rig.fastest, 0.0);
}

TEST(Navigator, NeedsABaseAndSonars) {
  robot::RobotDescription robot = the_robot();
  robot.sonars.reset();
  EXPECT_THROW(Navigator(robot, NavigatorParameters()), std::invalid_argument);
  robot = the_robot();
  robot.base.reset();
  EXPECT_THROW(Navigator(robot, NavigatorParameters()), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::base_navigator::test
