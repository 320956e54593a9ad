#pragma once

#include <cmath>
#include <string>

namespace markservo::mark_detector {

// A share of 1 for people: "37%".
inline std::string percent(double share) {
  return std::to_string(std::lround(100.0 * share)) + "%";
}

}  // namespace markservo::mark_detector
