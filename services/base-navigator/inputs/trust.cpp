#include "services/base-navigator/inputs/trust.hpp"

#include <fmt/format.h>

#include "common/motion/freshness.hpp"

namespace markservo::base_navigator {
namespace {

// Empty unless `utime` is too far from now.
std::string why_old(const char* what, std::int64_t utime, std::int64_t now, double allowed) {
  return motion::why_not_fresh({what, "WHEEL_ODOMETRY", allowed, allowed}, utime, now);
}

}  // namespace

std::string why_goal_is_stale(const TrustParameters& trust, std::int64_t utime, const OdometryTrack& track) {
  return why_old("BASE_GOAL", utime, track.newest_utime(), trust.goal_age);
}

std::string why_stale(const TrustParameters& trust, const OdometryTrack& track, const std::optional<PoseSample>& pose,
                      const SonarMemory& sonars) {
  const std::int64_t now = track.newest_utime();
  if (track.empty()) return "no WHEEL_ODOMETRY yet";
  if (!track.problem().empty()) return "WHEEL_ODOMETRY: " + track.problem();
  if (!pose) return "no ROBOT_POSE yet";
  if (auto why = why_old("ROBOT_POSE", pose->utime, now, trust.pose_age); !why.empty()) return why;
  if (!track.at(pose->utime, trust.pose_age)) return "ROBOT_POSE is of before WHEEL_ODOMETRY";
  const std::int64_t scan = sonars.newest_utime(track);
  if (scan == 0) return "no SONAR_SCAN since WHEEL_ODOMETRY began";
  return why_old("SONAR_SCAN", scan, now, trust.scan_age);
}

std::string why_lost(const TrustParameters& trust, const ExploreParameters& explore, const PoseSample& pose,
                     bool exploration_failed) {
  if (pose.state == Localisation::kLost) return "ROBOT_POSE is lost: " + pose.reason;
  const bool heading_known = pose.heading_sigma <= trust.heading_sigma;
  const bool may_explore = explore.enabled && !heading_known;
  if (pose.state == Localisation::kSearching && !may_explore) return "ROBOT_POSE is searching: " + pose.reason;
  const double allowed = may_explore ? explore.position_sigma : trust.position_sigma;
  if (pose.position_sigma > allowed) {
    return fmt::format("the position's sigma is {:.2f} m; allowed: {:.2f} m", pose.position_sigma, allowed);
  }
  if (!heading_known && !may_explore) {
    return fmt::format("the heading's sigma is {:.2f} rad; allowed: {:.2f} rad", pose.heading_sigma,
                       trust.heading_sigma);
  }
  if (!heading_known && exploration_failed) {
    return fmt::format("the heading did not become known within {:.2f} m", explore.distance);
  }
  return "";
}

geometry::PlanePose reckoned_pose(const TrustParameters& trust, const PoseSample& pose, const OdometryTrack& track) {
  const auto X_OR_then = track.at(pose.utime, trust.pose_age);
  return pose.X_WR * (X_OR_then->inverse() * track.newest());
}

}  // namespace markservo::base_navigator
