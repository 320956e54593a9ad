#include "tests/experiments/drive_truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <markservo/TaskState.hpp>
#include <string>

#include "common/geometry/plane_pose.hpp"
#include "common/time/seconds_between.hpp"
#include "tests/experiments/statistics.hpp"

namespace markservo::experiments {
namespace {

constexpr std::size_t kRecent = 100;    // 2 s of WHEEL_ODOMETRY
constexpr double kDockReach = 0.10;     // m: from further off the goal, it did not drive there
constexpr double kDockHeading = 0.17;   // rad: 10 degrees
constexpr double kStandsStill = 0.005;  // m

double distance(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

PoseError pose_error(const Pose2& a, const Pose2& b) {
  return {distance(a, b), std::abs(geometry::wrapped(a.heading - b.heading))};
}

DriveWatch::DriveWatch(bus::Bus& bus) {
  // In this order: a pose is compared with the truth that came before it.
  bus.on_each(channels::kSimBaseTruth, [this](const SimBaseTruth& truth) { note(truth); });
  bus.on_each(channels::kRobotPose, [this](const RobotPose& told) { note(told); });
}

bool DriveWatch::driving() const {
  return phase_ == TaskState::DRIVE;
}

void DriveWatch::observe(std::int8_t phase) {
  const bool before = driving();
  phase_ = phase;
  if (driving() && !before) ++drives_;
  if (before && !driving() && !arrived_) {
    arrived_ = last_;
    told_error_arrived_ = told_error_;
  }
}

void DriveWatch::note(const SimBaseTruth& truth) {
  recent_.push_back(truth);
  if (recent_.size() > kRecent) recent_.pop_front();
  const bool same_world = last_ && last_->session == truth.session && truth.utime >= last_->utime;
  if (same_world && phase_) {
    (driving() ? way_ : strayed_) += distance(truth.pose, last_->pose);
    if (driving()) seconds_ += seconds_between(last_->utime, truth.utime);
    touched_ = touched_ || truth.touched != 0;
    nearest_ = std::min(nearest_.value_or(truth.nearest), truth.nearest);
    if (driving()) true_way_.push_back(truth.pose);
  }
  last_ = truth;
}

void DriveWatch::note(const RobotPose& told) {
  if (told.state != RobotPose::LOCALISED) return;
  const auto truth = std::find_if(recent_.rbegin(), recent_.rend(), [&](const SimBaseTruth& other) {
    return other.odometry_seq == told.odometry_seq && other.utime == told.utime;
  });
  if (truth == recent_.rend()) return;
  told_error_ = pose_error(told.pose, truth->pose);
  if (!driving()) return;
  told_way_.push_back(told.pose);
  told_errors_.push_back(told_error_.position);
}

DriveResult DriveWatch::result(const Pose2& goal) const {
  DriveResult result;
  result.known = last_.has_value();
  if (!result.known) return result;
  result.drives = drives_;
  result.seconds = seconds_;
  result.way = way_;
  result.strayed = strayed_;
  if (rest_since_way_) result.moved_at_end = way_ + strayed_ - *rest_since_way_;
  result.touched = touched_;
  result.nearest = nearest_.value_or(NAN);
  result.error = pose_error((arrived_ ? *arrived_ : *last_).pose, goal);
  result.told_error = arrived_ ? told_error_arrived_ : told_error_;
  result.told_mean = mean(told_errors_);
  result.told_max = maximum(told_errors_);
  return result;
}

bool truly_driven(const DriveResult& drive) {
  return drive.known && drive.drives > 0 && drive.error.position < kDockReach && drive.error.heading < kDockHeading &&
         !drive.touched && drive.strayed < kStandsStill;
}

nlohmann::json report_of(const DriveResult& drive, const Pose2& goal) {
  const auto number = [](double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); };
  nlohmann::json report{{"goal_m_m_deg", {goal.x, goal.y, geometry::degrees(goal.heading)}}, {"known", drive.known}};
  if (!drive.known) return report;
  report.update({{"truly_driven", truly_driven(drive)},
                 {"drives", drive.drives},
                 {"seconds", drive.seconds},
                 {"way_m", drive.way},
                 {"moved_outside_drives_m", drive.strayed},
                 {"moved_at_end_m", drive.moved_at_end ? number(*drive.moved_at_end) : nlohmann::json()},
                 {"touched", drive.touched},
                 {"nearest_m", number(drive.nearest)},
                 {"error_m", drive.error.position},
                 {"error_deg", geometry::degrees(drive.error.heading)},
                 {"robot_pose_error_m", drive.told_error.position},
                 {"robot_pose_error_deg", geometry::degrees(drive.told_error.heading)},
                 {"robot_pose_error_mean_m", number(drive.told_mean)},
                 {"robot_pose_error_max_m", number(drive.told_max)}});
  return report;
}

std::string words_of(const DriveResult& drive) {
  if (!drive.known) return "  drive         the simulator tells no SIM_BASE_TRUTH\n";
  char text[512];
  std::snprintf(
      text, sizeof text,
      "  drive         %.2f m in %.1f s, %d drive%s; off its goal by %.1f cm and %.1f degrees; %s, nearest thing "
      "%.1f cm away\n"
      "  robot pose    off by %.1f cm and %.1f degrees at the end, while driving by %.1f cm in the mean, %.1f cm at "
      "most\n",
      drive.way, drive.seconds, drive.drives, drive.drives == 1 ? "" : "s", 1e2 * drive.error.position,
      geometry::degrees(drive.error.heading), drive.touched ? "touched something" : "touched nothing",
      1e2 * drive.nearest, 1e2 * drive.told_error.position, geometry::degrees(drive.told_error.heading),
      1e2 * drive.told_mean, 1e2 * drive.told_max);
  return text;
}

}  // namespace markservo::experiments
