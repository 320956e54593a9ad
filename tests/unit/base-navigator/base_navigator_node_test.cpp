// base-navigator on a bus: one status and one command per WHEEL_ODOMETRY, whatever else comes or stays away.

#include "services/base-navigator/base_navigator_node.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/SonarEcho.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/StopState.hpp>
#include <markservo/WheelOdometry.hpp>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/bus/node_on_a_bus.hpp"

namespace markservo::base_navigator {
namespace {

class BaseNavigatorOnABus : public bus::NodeOnABus<BaseNavigatorNode> {
 protected:
  BaseNavigatorOnABus() : NodeOnABus("base-navigator") {
    start_node();
    bus_.on_each(channels::kBaseStatus, [this](const BaseStatus& status) {
      statuses_.push_back(status);
      order_ += 's';
    });
    bus_.on_each(channels::kBaseCommand, [this](const BaseCommand& command) {
      commands_.push_back(command);
      order_ += 'c';
    });
  }

  void tell_stop(bool latched, const std::string& device = "base") {
    tell(stops_, bus::stop_state(utime_, device, latched));
  }

  void tell_goal(std::int64_t id, double x) {
    BaseGoal goal{};
    goal.utime = utime_;
    goal.session = 21;
    goal.goal_id = id;
    goal.kind = BaseGoal::DRIVE;
    goal.pose.x = x;
    tell(goals_, goal);
  }

  void tell_scan(int number = 16) {
    SonarScan scan{};
    scan.utime = utime_;
    scan.min_range = 0.1;
    scan.max_range = 5.0;
    scan.beam_width = 0.52;
    scan.num_echoes = number;
    for (int i = 0; i < number; ++i) {
      SonarEcho echo{};
      const double direction = 2.0 * M_PI * i / 16.0;
      echo.pose.x = 0.22 * std::cos(direction);
      echo.pose.y = 0.22 * std::sin(direction);
      echo.pose.heading = direction;
      echo.range = 5.0;
      scan.echoes.push_back(echo);
    }
    tell(scans_, scan);
  }

  void tell_odometry() {
    utime_ += 20'000;
    WheelOdometry odometry{};
    odometry.utime = utime_;
    tell(odometry_, odometry);
  }

  // That answers the odometry `back` before the newest one.
  void tell_pose(int back = 0) {
    RobotPose pose{};
    pose.utime = utime_ - std::int64_t{20'000} * back;
    pose.odometry_session = odometry_.session();
    pose.odometry_seq = odometry_seq() - back;
    pose.state = RobotPose::LOCALISED;
    pose.covariance.xx = pose.covariance.yy = 1e-4;
    pose.covariance.hh = 1e-3;
    tell(poses_, pose);
  }

  std::int64_t odometry_seq() const { return (utime_ - kStart) / 20'000; }

  void cycle() {
    tell_odometry();
    if (odometry_seq() % 5 == 0) tell_scan();
    tell_pose();
  }

  static constexpr std::int64_t kStart = 1'700'000'000'000'000;
  bus::Publisher<StopState> stops_ = bus_.advertise(channels::kStopState);
  bus::Publisher<WheelOdometry> odometry_ = bus_.advertise(channels::kWheelOdometry);
  bus::Publisher<RobotPose> poses_ = bus_.advertise(channels::kRobotPose);
  bus::Publisher<SonarScan> scans_ = bus_.advertise(channels::kSonarScan);
  bus::Publisher<BaseGoal> goals_ = bus_.advertise(channels::kBaseGoal);
  std::int64_t utime_ = kStart;
  std::vector<BaseCommand> commands_;
  std::vector<BaseStatus> statuses_;
  std::string order_;
};

TEST_F(BaseNavigatorOnABus, AnswersEachOdometryOnceStatusFirst) {
  tell_stop(false);
  for (int i = 0; i < 20; ++i) cycle();
  ASSERT_EQ(commands_.size(), 20U);
  ASSERT_EQ(statuses_.size(), 20U);
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    EXPECT_EQ(commands_[i].odometry_session, odometry_.session());
    EXPECT_EQ(commands_[i].odometry_seq, static_cast<std::int64_t>(i) + 1);
    EXPECT_EQ(commands_[i].utime, kStart + 20'000 * (static_cast<std::int64_t>(i) + 1));
    EXPECT_EQ(statuses_[i].odometry_seq, commands_[i].odometry_seq);
    EXPECT_EQ(order_.substr(2 * i, 2), "sc");
  }
  EXPECT_EQ(statuses_.back().state, BaseStatus::HOLD);
}

TEST_F(BaseNavigatorOnABus, WaitsForThePoseThatAnswersTheOdometry) {
  tell_stop(false);
  for (int i = 0; i < 5; ++i) cycle();
  tell_odometry();
  EXPECT_EQ(commands_.size(), 5U);
  tell_pose();
  EXPECT_EQ(commands_.size(), 6U);
  tell_pose();  // once more: answered already
  EXPECT_EQ(commands_.size(), 6U);
}

TEST_F(BaseNavigatorOnABus, AnOdometryWhosePoseIsLostIsAnsweredBeforeTheNext) {
  tell_stop(false);
  for (int i = 0; i < 5; ++i) cycle();
  tell_odometry();
  tell_odometry();
  ASSERT_EQ(commands_.size(), 6U);
  EXPECT_EQ(commands_.back().odometry_seq, 6);
  tell_pose(1);  // late
  EXPECT_EQ(commands_.size(), 6U);
  tell_pose();
  ASSERT_EQ(commands_.size(), 7U);
  EXPECT_EQ(commands_.back().odometry_seq, 7);
}

TEST_F(BaseNavigatorOnABus, StandsAndAnswersAtOnceWhilePosesStayAway) {
  tell_stop(false);
  for (int i = 0; i < 5; ++i) cycle();
  for (int i = 0; i < 50; ++i) {
    if (i % 5 == 0) tell_scan();
    if (i % 10 == 0) tell_goal(1, 3.0);
    cycle();
  }
  EXPECT_EQ(statuses_.back().state, BaseStatus::DRIVING) << statuses_.back().reason;
  EXPECT_GT(commands_.back().speed, 0.1);
  const std::size_t before = commands_.size();
  for (int i = 0; i < 15; ++i) {
    if (i % 5 == 0) tell_scan();
    if (i % 10 == 0) tell_goal(1, 3.0);
    tell_odometry();
  }
  EXPECT_EQ(commands_.size(), before + 15);
  EXPECT_EQ(statuses_.back().state, BaseStatus::STALE);
  EXPECT_NE(statuses_.back().reason.find("ROBOT_POSE"), std::string::npos);
  EXPECT_EQ(commands_.back().speed, 0.0);
}

TEST_F(BaseNavigatorOnABus, OnlyTheBasesStopStateCountsAndAResetDoesNotResume) {
  tell_stop(false);
  tell_stop(true, "arm");
  for (int i = 0; i < 30; ++i) {
    if (i % 10 == 0) tell_goal(1, 3.0);
    cycle();
  }
  EXPECT_EQ(statuses_.back().state, BaseStatus::DRIVING) << statuses_.back().reason;
  EXPECT_EQ(statuses_.back().goal_id, 1);
  EXPECT_EQ(statuses_.back().goal_session, 21);
  EXPECT_NEAR(statuses_.back().distance, 3.0, 0.1);
  tell_stop(true);
  cycle();
  EXPECT_EQ(statuses_.back().state, BaseStatus::STOPPED);
  EXPECT_EQ(commands_.back().speed, 0.0);
  tell_stop(false);
  tell_goal(1, 3.0);
  cycle();
  EXPECT_EQ(statuses_.back().state, BaseStatus::HOLD);
  EXPECT_EQ(commands_.back().speed, 0.0);
}

TEST_F(BaseNavigatorOnABus, SaysStoppedUntilTheFirstStopState) {
  cycle();
  ASSERT_EQ(statuses_.size(), 1U);
  EXPECT_EQ(statuses_.back().state, BaseStatus::STOPPED);
  EXPECT_EQ(commands_.back().speed, 0.0);
}

TEST_F(BaseNavigatorOnABus, CountsWhatItRefuses) {
  tell_stop(false);
  for (int i = 0; i < 5; ++i) cycle();
  tell_scan(15);
  EXPECT_EQ(refused(bus_, "SONAR_SCAN"), 1);
  BaseGoal goal{};
  goal.utime = utime_;
  goal.session = 22;
  goal.goal_id = 1;
  goal.kind = BaseGoal::DRIVE;
  goal.frame = BaseGoal::ROBOT;
  goal.pose.x = 5000.0;
  tell(goals_, goal);
  EXPECT_EQ(refused(bus_, "BASE_GOAL"), 1);
  WheelOdometry late{};
  late.utime = utime_ - 1'000'000;
  tell(odometry_, late);
  EXPECT_EQ(refused(bus_, "WHEEL_ODOMETRY"), 1);
  EXPECT_EQ(refused(bus_, "ROBOT_POSE"), 0);
}

void expect_refused(const char* options, const char* named, const char* allowed) {
  CLI::App app;
  BaseNavigatorNode node;
  node.add_options(app);
  app.parse(options, false);
  try {
    node.configure(bus::kRobotFile);
    FAIL() << options;
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(allowed), std::string::npos) << error.what();
  }
}

TEST(BaseNavigatorConfiguration, AStopDeviceThatTheRobotDoesNotHaveIsRefused) {
  expect_refused("--stop-device wing", "'wing'", "base");
}

TEST(BaseNavigatorConfiguration, ACoarseToleranceBelowTheFineOneIsRefused) {
  expect_refused("--tolerance 0.05", "--coarse-tolerance", "0.05");
}

}  // namespace
}  // namespace markservo::base_navigator
