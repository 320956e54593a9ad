// The rules of what the base's services say to each other.

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "common/bus/message_rules.hpp"
#include "common/bus/rule_words.hpp"

namespace markservo::bus {
namespace {

constexpr double kMaxRate = 1e4;      // m/s or rad/s
constexpr double kMaxDistance = 1e8;  // m, way of a wheel since the start
constexpr int64_t kMaxRound_us = 60'000'000;
constexpr int32_t kMaxHits = 10'000;
constexpr int32_t kMaxEchoes = 64;
constexpr std::size_t kMaxUidLength = 64;
constexpr double kMaxSonarRange = 100.0;  // m; ultrasound in air is gone long before

std::string time_violation(const char* field, int64_t utime) {
  if (utime >= 0 && utime <= kMaxCount) return {};
  return std::string(field) + " is " + std::to_string(utime) + "; allowed: 0 to 2^53 us";
}

}  // namespace

std::string violation(const RfidTagHits& hits) {
  for (const int64_t utime : {hits.window_start, hits.window_end}) {
    if (auto why = time_violation("window_start or window_end", utime); !why.empty()) return why;
  }
  const int64_t round = hits.window_end - hits.window_start;
  if (round < 0 || round > kMaxRound_us) {
    return wrong("window_end - window_start", static_cast<double>(round), "0 to 60000000 us");
  }
  if (hits.window_end > hits.utime) {
    return wrong("window_end", static_cast<double>(hits.window_end), "utime or before");
  }
  if (hits.num_hits > kMaxHits) return wrong("num_hits", hits.num_hits, "at most 10000");
  for (const auto& hit : hits.hits) {
    if (hit.uid.empty() || hit.uid.size() > kMaxUidLength) {
      return wrong("length of a uid", static_cast<double>(hit.uid.size()), "1 to 64 characters");
    }
    for (const int64_t utime : {hit.utime, hit.read_utime}) {
      if (auto why = time_violation("a hit's utime or read_utime", utime); !why.empty()) return why;
    }
    if (hit.rssi_known && !std::isfinite(hit.rssi)) return not_finite("rssi");
  }
  return {};
}

std::string violation(const WheelOdometry& odometry) {
  if (auto why = beyond("left_distance", odometry.left_distance, kMaxDistance); !why.empty()) return why;
  return beyond("right_distance", odometry.right_distance, kMaxDistance);
}

std::string violation(const SonarScan& scan) {
  if (!all_finite({scan.min_range, scan.max_range, scan.beam_width})) return not_finite("a range or the beam's width");
  if (scan.min_range < 0.0 || scan.min_range >= scan.max_range || scan.max_range > kMaxSonarRange) {
    return wrong("max_range", scan.max_range, "above min_range, which is 0 or more, up to 100 m");
  }
  if (scan.beam_width < 0.0 || scan.beam_width > 2.0 * M_PI) {
    return wrong("beam_width", scan.beam_width, "0 to 2 pi rad");
  }
  if (scan.num_echoes > kMaxEchoes) return wrong("num_echoes", scan.num_echoes, "at most 64");
  for (const auto& echo : scan.echoes) {
    if (auto why = pose_violation("a sonar's pose", echo.pose); !why.empty()) return why;
    if (!std::isfinite(echo.range) || echo.range < 0.0 || echo.range > scan.max_range) {
      return wrong("range", echo.range, "0 m to max_range");
    }
  }
  return {};
}

std::string violation(const RobotPose& pose) {
  if (pose.state < RobotPose::SEARCHING || pose.state > RobotPose::LOST) return wrong("state", pose.state, "0, 1 or 2");
  if (auto why = pose_violation("pose", pose.pose); !why.empty()) return why;
  const auto& c = pose.covariance;
  if (!all_finite({c.xx, c.xy, c.xh, c.yy, c.yh, c.hh})) return not_finite("covariance");
  for (const double variance : {c.xx, c.yy, c.hh}) {
    if (variance < 0.0 || variance > kMaxCovariance)
      return wrong("covariance", variance, "0 to 1000000 on the diagonal");
  }
  for (const double rate : {pose.speed, pose.turn_rate}) {
    if (auto why = beyond("speed or turn_rate", rate, kMaxRate); !why.empty()) return why;
  }
  const auto& paper = pose.paper;
  if (!all_finite({pose.delay, pose.delay_sigma, paper.measured_x, paper.measured_y, paper.direction, paper.speed,
                   paper.delay, paper.compensated_x, paper.compensated_y})) {
    return not_finite("delay or paper");
  }
  return {};
}

std::string violation(const BaseGoal& goal) {
  if (goal.kind < BaseGoal::HOLD || goal.kind > BaseGoal::DRIVE) return wrong("kind", goal.kind, "0 or 1");
  if (goal.frame < BaseGoal::WORLD || goal.frame > BaseGoal::ROBOT) return wrong("frame", goal.frame, "0 or 1");
  if (auto why = pose_violation("pose", goal.pose); !why.empty()) return why;
  if (!std::isfinite(goal.clearance) || goal.clearance < 0.0 || goal.clearance > kMaxPosition) {
    return wrong("clearance", goal.clearance, "0 to 10000 m");
  }
  if (!std::isfinite(goal.speed) || goal.speed < 0.0 || goal.speed > kMaxRate) {
    return wrong("speed", goal.speed, "0 to 10000 m/s");
  }
  return {};
}

std::string violation(const BaseStatus& status) {
  if (status.state < BaseStatus::HOLD || status.state > BaseStatus::STOPPED)
    return wrong("state", status.state, "0 to 6");
  return all_finite({status.distance, status.heading_error}) ? "" : not_finite("distance or heading_error");
}

std::string violation(const BaseCommand& command) {
  if (auto why = beyond("speed", command.speed, kMaxRate); !why.empty()) return why;
  return beyond("turn_rate", command.turn_rate, kMaxRate);
}

}  // namespace markservo::bus
