// The rules of what the base's services say to each other.

#include <cmath>
#include <cstdint>
#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/WheelOdometry.hpp>

#include "common/messages/rule_words.hpp"

namespace markservo::messages {
namespace {

constexpr double kMaxDistance = 1e8;  // m, way of a wheel since the start
constexpr std::int64_t kMaxRound_us = 60'000'000;
constexpr std::int32_t kMaxHits = 10'000;
constexpr std::int32_t kMaxEchoes = 64;
constexpr std::size_t kMaxUidLength = 64;
constexpr double kMaxSonarRange = 100.0;  // m; ultrasound in air is gone long before

std::string time_violation(const char* field, std::int64_t utime) {
  if (utime >= 0 && utime <= kMaxCount) return {};
  return wrong(field, utime, "0 to 2^53 us");
}

template <class Hits, class Visit>
void each_text_of_hits(Hits& hits, Visit& visit) {
  for (auto& hit : hits.hits) visit("a hit's uid", hit.uid);
}

}  // namespace

std::string MessageRules<RfidTagHits>::violation(const RfidTagHits& hits) {
  TextCheck texts;
  each_text_of_hits(hits, texts);
  if (!texts.why().empty()) return texts.why();
  if (auto why = time_violation("window_start", hits.window_start); !why.empty()) return why;
  if (auto why = time_violation("window_end", hits.window_end); !why.empty()) return why;
  const std::int64_t round = hits.window_end - hits.window_start;
  if (round < 0 || round > kMaxRound_us) {
    return wrong("window_end - window_start", round, "0 to 60000000 us");
  }
  if (hits.window_end > hits.utime) {
    return wrong("window_end", hits.window_end, "utime or before");
  }
  if (hits.num_hits > kMaxHits) return wrong("num_hits", hits.num_hits, "at most 10000");
  for (const auto& hit : hits.hits) {
    if (hit.uid.empty() || hit.uid.size() > kMaxUidLength) {
      return wrong("length of a uid", hit.uid.size(), "1 to 64 characters");
    }
    if (auto why = time_violation("a hit's utime", hit.utime); !why.empty()) return why;
    if (auto why = time_violation("a hit's read_utime", hit.read_utime); !why.empty()) return why;
    if (hit.rssi_known && !std::isfinite(hit.rssi)) return not_finite("rssi");
  }
  return {};
}

void MessageRules<RfidTagHits>::clean_texts(RfidTagHits& hits) {
  TextCleaner cleaner;
  each_text_of_hits(hits, cleaner);
}

std::string MessageRules<WheelOdometry>::violation(const WheelOdometry& odometry) {
  if (auto why = beyond("left_distance", odometry.left_distance, kMaxDistance); !why.empty()) return why;
  return beyond("right_distance", odometry.right_distance, kMaxDistance);
}

std::string MessageRules<SonarScan>::violation(const SonarScan& scan) {
  if (!all_finite({scan.min_range, scan.max_range, scan.beam_width})) return not_finite("a range or the beam's width");
  if (scan.min_range < 0.0) return wrong("min_range", scan.min_range, "0 m or more");
  if (scan.max_range <= scan.min_range || scan.max_range > kMaxSonarRange) {
    return wrong("max_range", scan.max_range, "above min_range, up to 100 m");
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

std::string MessageRules<RobotPose>::violation(const RobotPose& pose) {
  if (auto why = text::violation("reason", pose.reason); !why.empty()) return why;
  if (auto why = enum_violation("state", pose.state, RobotPose::LOST); !why.empty()) return why;
  if (auto why = pose_violation("pose", pose.pose); !why.empty()) return why;
  const auto& c = pose.covariance;
  if (!all_finite({c.xx, c.xy, c.xh, c.yy, c.yh, c.hh})) return not_finite("covariance");
  for (const double variance : {c.xx, c.yy, c.hh}) {
    if (variance < 0.0 || variance > kMaxCovariance)
      return wrong("covariance", variance, "0 to 1000000 on the diagonal");
  }
  if (auto why = beyond("speed", pose.speed, kMaxRate); !why.empty()) return why;
  if (auto why = beyond("turn_rate", pose.turn_rate, kMaxRate); !why.empty()) return why;
  const auto& paper = pose.paper;
  if (!all_finite({pose.delay, pose.delay_sigma, paper.measured_x, paper.measured_y, paper.direction, paper.speed,
                   paper.delay, paper.compensated_x, paper.compensated_y})) {
    return not_finite("delay or paper");
  }
  return {};
}

void MessageRules<RobotPose>::clean_texts(RobotPose& pose) {
  text::clean(pose.reason);
}

std::string MessageRules<BaseGoal>::violation(const BaseGoal& goal) {
  if (auto why = enum_violation("kind", goal.kind, BaseGoal::DRIVE); !why.empty()) return why;
  if (auto why = enum_violation("frame", goal.frame, BaseGoal::ROBOT); !why.empty()) return why;
  if (auto why = pose_violation("pose", goal.pose); !why.empty()) return why;
  if (!std::isfinite(goal.clearance) || goal.clearance < 0.0 || goal.clearance > kMaxPosition) {
    return wrong("clearance", goal.clearance, "0 to 10000 m");
  }
  if (!std::isfinite(goal.speed) || goal.speed < 0.0 || goal.speed > kMaxRate) {
    return wrong("speed", goal.speed, "0 to 10000 m/s");
  }
  return {};
}

std::string MessageRules<BaseStatus>::violation(const BaseStatus& status) {
  if (auto why = text::violation("reason", status.reason); !why.empty()) return why;
  if (auto why = enum_violation("state", status.state, BaseStatus::STOPPED); !why.empty()) return why;
  return all_finite({status.distance, status.heading_error}) ? "" : not_finite("distance or heading_error");
}

void MessageRules<BaseStatus>::clean_texts(BaseStatus& status) {
  text::clean(status.reason);
}

std::string MessageRules<BaseCommand>::violation(const BaseCommand& command) {
  if (auto why = beyond("speed", command.speed, kMaxRate); !why.empty()) return why;
  return beyond("turn_rate", command.turn_rate, kMaxRate);
}

}  // namespace markservo::messages
