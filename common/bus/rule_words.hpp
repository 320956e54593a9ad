#pragma once

// The words that message rules share.

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <markservo/Pose2.hpp>
#include <string>

namespace markservo::bus {

inline constexpr double kMaxCovariance = 1e6;  // m^2 or rad^2; beyond it the value says nothing
inline constexpr double kMaxPosition = 1e4;    // m; nothing a robot sees or reaches is farther

inline constexpr double kMaxAngle = 1e4;  // rad; a joint or heading may wind up, but not for ever

inline bool all_finite(std::initializer_list<double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

inline std::string not_finite(const char* field) {
  return std::string(field) + " is not finite; allowed: finite numbers";
}

inline std::string wrong(const char* field, double value, const char* allowed) {
  return std::string(field) + " is " + std::to_string(value) + "; allowed: " + allowed;
}

inline std::string beyond(const char* field, double value, double most) {
  if (std::isfinite(value) && std::abs(value) <= most) return {};
  return std::string(field) + " is " + std::to_string(value) + "; allowed: up to " +
         std::to_string(static_cast<int64_t>(most)) + " either way";
}

inline std::string pose_violation(const char* field, const Pose2& pose) {
  for (const double value : {pose.x, pose.y}) {
    if (auto why = beyond(field, value, kMaxPosition); !why.empty()) return why;
  }
  return beyond(field, pose.heading, kMaxAngle);
}

}  // namespace markservo::bus
