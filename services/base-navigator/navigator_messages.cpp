#include "services/base-navigator/navigator_messages.hpp"

#include <cmath>
#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/WheelOdometry.hpp>

#include "common/messages/state_codes.hpp"

namespace markservo::base_navigator {
namespace {

using geometry::PlanePose;
using geometry::wrapped;

PlanePose plane_pose(const Pose2& pose) {
  return {pose.x, pose.y, wrapped(pose.heading)};
}

// m, standard deviation along the axis in which the position is known worst.
double worst_sigma(const PoseCovariance2& c) {
  const double mean = 0.5 * (c.xx + c.yy);
  return std::sqrt(std::fmax(0.0, mean + std::hypot(0.5 * (c.xx - c.yy), c.xy)));
}

template <class M>
void answer(M& message, const OdometryId& odometry) {
  message.utime = odometry.utime;
  message.odometry_session = odometry.session;
  message.odometry_seq = odometry.seq;
}

}  // namespace

OdometrySample odometry_sample(const WheelOdometry& message) {
  return {message.utime, message.left_distance, message.right_distance};
}

PoseSample pose_sample(const RobotPose& message) {
  PoseSample sample;
  sample.utime = message.utime;
  sample.state = messages::state_of<Localisation>(message.state);
  sample.X_WR = plane_pose(message.pose);
  sample.position_sigma = worst_sigma(message.covariance);
  sample.heading_sigma = std::sqrt(message.covariance.hh);
  sample.reason = message.reason;
  return sample;
}

SonarScanSample scan_sample(const SonarScan& message) {
  SonarScanSample sample;
  sample.utime = message.utime;
  sample.min_range = message.min_range;
  sample.max_range = message.max_range;
  sample.beam_width = message.beam_width;
  for (const SonarEcho& echo : message.echoes) {
    sample.readings.push_back({plane_pose(echo.pose), echo.heard != 0, echo.range});
  }
  return sample;
}

Goal goal_of(const BaseGoal& message) {
  Goal goal;
  goal.utime = message.utime;
  goal.session = message.session;
  goal.id = message.goal_id;
  goal.kind = message.kind == BaseGoal::DRIVE ? GoalKind::kDrive : GoalKind::kHold;
  goal.frame = message.frame == BaseGoal::ROBOT ? GoalFrame::kRobot : GoalFrame::kWorld;
  goal.pose = plane_pose(message.pose);
  goal.clearance = message.clearance;
  goal.speed = message.speed;
  return goal;
}

OdometryId identity(const WheelOdometry& message) {
  return {message.utime, message.session, message.seq};
}

OdometryId identity(const RobotPose& message) {
  return {message.utime, message.odometry_session, message.odometry_seq};
}

BaseCommand command_message(const Command& command, const OdometryId& odometry) {
  BaseCommand message{};
  answer(message, odometry);
  message.speed = command.speed;
  message.turn_rate = command.turn_rate;
  return message;
}

BaseStatus status_message(const Status& status, const OdometryId& odometry) {
  BaseStatus message{};
  answer(message, odometry);
  message.goal_session = status.goal_session;
  message.goal_id = status.goal_id;
  message.state = messages::code_of(status.state);
  message.distance = status.distance;
  message.heading_error = status.heading_error;
  message.reason = status.reason;
  return message;
}

}  // namespace markservo::base_navigator
