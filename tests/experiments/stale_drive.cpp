#include "tests/experiments/stale_drive.hpp"

#include <algorithm>
#include <cmath>
#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/RobotPose.hpp>

#include "common/geometry/plane_pose.hpp"
#include "common/time/seconds_between.hpp"

namespace markservo::experiments {
namespace {

constexpr double kDrives = 0.05;  // m/s

// base-navigator stands by its gentle deceleration when a pose or a goal is old. Goals come five times a second only.
SilenceLimits pose_limits() {
  SilenceLimits limits;
  limits.braking = 0.4;
  return limits;
}

SilenceLimits goal_limits() {
  SilenceLimits limits = pose_limits();
  limits.age = 0.6;
  return limits;
}

}  // namespace

void SilenceWatch::begin_anew(std::int64_t utime) {
  newest_ = utime;
  rest_age_.reset();
  drove_ = last_ && std::abs(last_->speed) > kDrives;
}

void SilenceWatch::message(std::int64_t utime) {
  if (!newest_ || utime > *newest_) begin_anew(utime);
}

void SilenceWatch::observe(const SimBaseTruth& truth) {
  const bool same_world = last_ && last_->session == truth.session && truth.utime >= last_->utime;
  if (last_ && !same_world) {
    newest_.reset();
    rest_age_.reset();
  }
  if (same_world && newest_) {
    const double age = seconds_between(*newest_, truth.utime);
    if (drove_) longest_ = std::max(longest_, age);
    if (rest_age_ && seconds_between(*newest_, last_->utime) > *rest_age_) {
      moved_ += std::hypot(truth.pose.x - last_->pose.x, truth.pose.y - last_->pose.y);
      turned_ += std::abs(geometry::wrapped(truth.pose.heading - last_->pose.heading));
    }
    if (!rest_age_ && age >= limits_.age) {
      rest_age_ = age + limits_.margin +
                  std::max(std::abs(truth.speed) / limits_.braking, std::abs(truth.turn_rate) / limits_.turn_braking);
    }
  }
  last_ = truth;
}

StaleDriveWatch::StaleDriveWatch(bus::Bus& bus)
    : pose_(pose_limits()), command_(SilenceLimits()), goal_(goal_limits()) {
  bus.on_each(channels::kRobotPose, [this](const RobotPose& told) { pose_.message(told.utime); });
  bus.on_each(channels::kBaseCommand, [this](const BaseCommand& command) { command_.message(command.utime); });
  bus.on_each(channels::kBaseGoal, [this](const BaseGoal& goal) { goal_.message(goal.utime); });
  bus.on_each(channels::kSimBaseTruth, [this](const SimBaseTruth& truth) {
    for (SilenceWatch* watch : {&pose_, &command_, &goal_}) watch->observe(truth);
  });
}

nlohmann::json report_of(const StaleDriveWatch& watch) {
  const auto silence = [](const SilenceWatch& channel) {
    return nlohmann::json{
        {"longest_s", channel.longest()}, {"moved_m", channel.moved()}, {"turned_rad", channel.turned()}};
  };
  return {{channels::kRobotPose.name, silence(watch.pose())},
          {channels::kBaseCommand.name, silence(watch.command())},
          {channels::kBaseGoal.name, silence(watch.goal())}};
}

}  // namespace markservo::experiments
