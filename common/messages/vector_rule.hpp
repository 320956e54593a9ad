#pragma once

// What a Vector3 in a message may be.

#include <algorithm>
#include <cmath>
#include <markservo/Vector3.hpp>
#include <string>

#include "common/messages/rule_words.hpp"

namespace markservo::messages {

inline bool finite(const Vector3& v) {
  return all_finite({v.x, v.y, v.z});
}

// Finite, and so near that sums and squares of it stay finite too.
inline std::string near_violation(const std::string& field, const Vector3& v) {
  for (const double value : {v.x, v.y, v.z}) {
    if (!std::isfinite(value) || std::abs(value) > kMaxPosition) return wrong(field, value, "-10000 to 10000 m");
  }
  return {};
}

}  // namespace markservo::messages
