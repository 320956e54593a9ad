#include "tests/experiments/drive_truth.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <markservo/TaskState.hpp>

#include "tests/unit/bus/memq_bus.hpp"

namespace markservo::experiments {
namespace {

Pose2 pose(double x, double y, double heading) {
  Pose2 result{};
  result.x = x;
  result.y = y;
  result.heading = heading;
  return result;
}

class Drive : public ::testing::Test {
 protected:
  // One WHEEL_ODOMETRY later the base is truly at y, and ROBOT_POSE says that it is `off` beside.
  void odometry(double y, double off = 0.01, std::int8_t state = RobotPose::LOCALISED) {
    utime_ += 20'000;
    truth_.utime = utime_;
    ++truth_.odometry_seq;
    truth_.pose = pose(0.2, y, 1.5);
    truth_.nearest = 1.5 - y;
    truths_.publish(truth_);
    RobotPose told{};
    told.utime = utime_;
    told.odometry_seq = truth_.odometry_seq;
    told.state = state;
    told.pose = pose(0.2 + off, y, 1.5);
    poses_.publish(told);
    settle(bus_);
  }

  void drive(double from, double to) {
    watch_.observe(TaskState::DRIVE);
    for (int i = 0; i <= 100; ++i) odometry(from + (to - from) * i / 100.0);
    watch_.observe(TaskState::LOOK);
  }

  bus::Bus bus_{bus::memq_parameters("experiment")};
  bus::Publisher<SimBaseTruth> truths_ = bus_.advertise(channels::kSimBaseTruth);
  bus::Publisher<RobotPose> poses_ = bus_.advertise(channels::kRobotPose);
  DriveWatch watch_{bus_};
  SimBaseTruth truth_{};
  std::int64_t utime_ = 1'000'000;
  const Pose2 goal_ = pose(0.2, 1.05, 1.55);
};

TEST_F(Drive, is_measured_by_way_time_and_end) {
  drive(0.05, 1.04);
  const DriveResult result = watch_.result(goal_);
  EXPECT_TRUE(result.known);
  EXPECT_EQ(result.drives, 1);
  EXPECT_NEAR(result.way, 0.99, 1e-9);
  EXPECT_NEAR(result.seconds, 2.0, 1e-9);
  EXPECT_NEAR(result.error.position, 0.01, 1e-9);
  EXPECT_NEAR(result.error.heading, 0.05, 1e-9);
  EXPECT_NEAR(result.nearest, 0.46, 1e-9);
  EXPECT_NEAR(result.told_error.position, 0.01, 1e-9);
  EXPECT_NEAR(result.told_mean, 0.01, 1e-9);
  EXPECT_TRUE(truly_driven(result));
}

TEST_F(Drive, is_judged_by_its_own_end_and_not_by_that_of_corrections) {
  drive(0.05, 1.04);
  drive(1.04, 1.25);
  const DriveResult result = watch_.result(goal_);
  EXPECT_EQ(result.drives, 2);
  EXPECT_NEAR(result.way, 1.20, 1e-9);
  EXPECT_NEAR(result.error.position, 0.01, 1e-9);
  EXPECT_TRUE(truly_driven(result));
}

TEST_F(Drive, that_ends_far_from_its_goal_is_none) {
  drive(0.05, 0.90);
  EXPECT_FALSE(truly_driven(watch_.result(goal_)));
}

TEST_F(Drive, that_touched_something_once_is_none) {
  watch_.observe(TaskState::DRIVE);
  odometry(0.05);
  truth_.touched = 1;
  odometry(0.06);
  truth_.touched = 0;
  drive(0.06, 1.05);
  const DriveResult result = watch_.result(goal_);
  EXPECT_TRUE(result.touched);
  EXPECT_FALSE(truly_driven(result));
}

TEST_F(Drive, a_base_that_moves_while_the_arm_works_is_told) {
  drive(0.05, 1.05);
  watch_.observe(TaskState::SERVO);
  odometry(1.04);
  const DriveResult result = watch_.result(goal_);
  EXPECT_NEAR(result.strayed, 0.01, 1e-9);
  EXPECT_NEAR(result.error.position, 0.0, 1e-9) << "the drive's end, not the task's";
  EXPECT_FALSE(truly_driven(result));
}

TEST_F(Drive, a_base_that_does_not_rest_in_the_end_is_told) {
  drive(0.05, 1.05);
  EXPECT_FALSE(watch_.result(goal_).moved_at_end) << "nobody watched";
  EXPECT_TRUE(report_of(watch_.result(goal_), goal_)["moved_at_end_m"].is_null());
  watch_.expect_rest();
  EXPECT_EQ(watch_.result(goal_).moved_at_end, 0.0);
  odometry(1.053);
  EXPECT_NEAR(watch_.result(goal_).moved_at_end.value(), 0.003, 1e-9);
}

TEST_F(Drive, a_base_that_never_drove_is_none) {
  watch_.observe(TaskState::LOOK);
  odometry(1.05);
  EXPECT_FALSE(truly_driven(watch_.result(goal_)));
}

TEST_F(Drive, a_pose_that_is_not_localised_is_not_judged) {
  watch_.observe(TaskState::DRIVE);
  odometry(0.05, 0.5, RobotPose::SEARCHING);
  odometry(0.06, 0.02);
  EXPECT_NEAR(watch_.result(goal_).told_max, 0.02, 1e-9);
  EXPECT_EQ(watch_.told_way().size(), 1u);
}

TEST_F(Drive, without_truth_is_unknown) {
  EXPECT_FALSE(watch_.result(goal_).known);
  EXPECT_FALSE(truly_driven(watch_.result(goal_)));
}

TEST(PoseError, takes_the_short_way_round) {
  EXPECT_NEAR(pose_error(pose(0, 0, 3.1), pose(0.3, 0.4, -3.1)).heading, 0.0832, 1e-4);
  EXPECT_NEAR(pose_error(pose(0, 0, 3.1), pose(0.3, 0.4, -3.1)).position, 0.5, 1e-12);
}

}  // namespace
}  // namespace markservo::experiments
