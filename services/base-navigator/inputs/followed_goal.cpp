#include "services/base-navigator/inputs/followed_goal.hpp"

#include <algorithm>

#include "common/time/seconds_between.hpp"

namespace markservo::base_navigator {
namespace {

// Empty for a goal that can be driven to.
std::string why_refused(const TrustParameters& trust, const Goal& goal, const OdometryTrack& track) {
  if (goal.kind == GoalKind::kHold) return "";
  if (goal.clearance < 0.0) return "clearance is " + std::to_string(goal.clearance) + " m; allowed: 0 or more";
  if (goal.speed < 0.0) return "speed is " + std::to_string(goal.speed) + " m/s; allowed: 0 or more";
  if (goal.frame == GoalFrame::kWorld) return "";
  if (goal.pose.distance() > trust.goal_distance) {
    return "the goal is " + std::to_string(goal.pose.distance()) +
           " m away; allowed: " + std::to_string(trust.goal_distance) + " m";
  }
  // The run before may have driven a part of it; driving it once more would end elsewhere.
  const double age = seconds_between(track.first_utime(), track.newest_utime());
  if (track.empty() || age < std::max(trust.restart_guard, trust.goal_age)) {
    return "a goal relative to the robot was given before the navigator had started; allowed: a new goal_id";
  }
  return "";
}

}  // namespace

motion::GoalHeard FollowedGoal::observe(const TrustParameters& trust, const Goal& goal, const OdometryTrack& track,
                                        bool latched) {
  const motion::GoalStamp stamp{goal.session, goal.id, goal.utime};
  const auto heard = inbox_.hear(stamp, track.newest_utime(), trust.goal_age, latched);
  if (!inbox_.goal()) goal_.reset();
  if (heard == motion::GoalHeard::kAgain) goal_->utime = inbox_.goal()->utime;
  if (heard != motion::GoalHeard::kNew) return heard;
  goal_ = goal;
  refusal_ = why_refused(trust, goal, track);
  dropped_.clear();
  X_WG_.reset();
  X_OG_.reset();
  if (goal.kind == GoalKind::kDrive && goal.frame == GoalFrame::kWorld) X_WG_ = goal.pose;
  if (goal.kind == GoalKind::kDrive && goal.frame == GoalFrame::kRobot) {
    X_OG_ = track.newest() * goal.pose;
    X_OG_epoch_ = track.epoch();
  }
  return heard;
}

void FollowedGoal::end_unless_fresh(const TrustParameters& trust, const OdometryTrack& track) {
  if (!inbox_.end_unless_fresh(track.newest_utime(), trust.goal_age)) return;
  dropped_ = "the goal heard before the first WHEEL_ODOMETRY is of another time: it was dropped";
  goal_.reset();
}

void FollowedGoal::end() {
  inbox_.end();
  goal_.reset();
}

void FollowedGoal::drop(const std::string& why) {
  if (goal_) dropped_ = why + ": the goal was dropped";
  end();
}

std::optional<geometry::PlanePose> FollowedGoal::place(const geometry::PlanePose& X_WR, const OdometryTrack& track) {
  if (X_WG_) return X_WG_;
  if (!X_OG_ || X_OG_epoch_ != track.epoch()) {
    refusal_ = "WHEEL_ODOMETRY was interrupted before a goal relative to the robot could be placed";
    return std::nullopt;
  }
  X_WG_ = X_WR * (track.newest().inverse() * *X_OG_);
  return X_WG_;
}

}  // namespace markservo::base_navigator
