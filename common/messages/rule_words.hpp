#pragma once

// The words that message rules share.

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <markservo/Pose2.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "common/messages/message_rules.hpp"
#include "common/text/text.hpp"

namespace markservo::messages {

inline constexpr double kMaxCovariance = 1e6;  // m^2 or rad^2; beyond it the value says nothing
inline constexpr double kMaxPosition = 1e4;    // m; nothing a robot sees or reaches is farther
inline constexpr double kMaxAngle = 1e4;       // rad; a joint or heading may wind up, but not for ever
inline constexpr double kMaxRate = 1e4;        // m/s or rad/s

// Any list of numbers.
template <class Numbers>
bool all_finite(const Numbers& values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}
inline bool all_finite(std::initializer_list<double> values) {
  return all_finite<std::initializer_list<double>>(values);
}

inline std::string not_finite(const std::string& field) {
  return field + " is not finite; allowed: finite numbers";
}

// "FIELD is VALUE; allowed: ALLOWED".
template <class Value>
std::string wrong(const std::string& field, Value value, const std::string& allowed) {
  if constexpr (std::is_integral_v<Value>) {
    return fmt::format("{} is {}; allowed: {}", field, value, allowed);
  } else {
    return fmt::format("{} is {:.9g}; allowed: {}", field, value, allowed);
  }
}

inline std::string beyond(const std::string& field, double value, double most) {
  if (std::isfinite(value) && std::abs(value) <= most) return {};
  return wrong(field, value, "up to " + std::to_string(static_cast<std::int64_t>(most)) + " either way");
}

// A state or kind, numbered from 0.
inline std::string enum_violation(const std::string& field, int value, int last) {
  if (value >= 0 && value <= last) return {};
  return wrong(field, value, "0 to " + std::to_string(last));
}

// An id, session or count that echoes another's: 0 stands for none.
inline std::string count_violation(const std::string& field, std::int64_t value) {
  if (value >= 0) return {};
  return wrong(field, value, "0 or more");
}

inline std::string pose_violation(const std::string& field, const Pose2& pose) {
  if (auto why = beyond(field + ".x", pose.x, kMaxPosition); !why.empty()) return why;
  if (auto why = beyond(field + ".y", pose.y, kMaxPosition); !why.empty()) return why;
  return beyond(field + ".heading", pose.heading, kMaxAngle);
}

// A family's file lists each type's texts once, for both of these.
class TextCheck {
 public:
  void operator()(const char* field, const std::string& text) {
    if (why_.empty()) why_ = text::violation(field, text);
  }
  const std::string& why() const { return why_; }

 private:
  std::string why_;
};

class TextCleaner {
 public:
  void operator()(const char* /*field*/, std::string& text) const { text::clean(text); }
};

}  // namespace markservo::messages
