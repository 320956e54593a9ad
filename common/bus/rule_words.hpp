#pragma once

// The words that message rules share.

#include <cmath>
#include <initializer_list>
#include <string>

namespace markservo::bus {

inline constexpr double kMaxCovariance = 1e6;  // m^2 or rad^2; beyond it the value says nothing
inline constexpr double kMaxPosition = 1e4;    // m; nothing a robot sees or reaches is farther

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

}  // namespace markservo::bus
