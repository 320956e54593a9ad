#pragma once

// The one conversion between radians, which all reckon in, and degrees, which people read and write.

#include <cmath>

namespace markservo::geometry {

inline constexpr double radians(double degrees) {
  return degrees * M_PI / 180.0;
}

inline constexpr double degrees(double radians) {
  return radians * 180.0 / M_PI;
}

// The same as factors, which round the last bit otherwise: for what must stay as it always was, a simulated world by
// its seed, a search by its grid, a text that others compare.
inline constexpr double kRadiansPerDegree = M_PI / 180.0;
inline constexpr double kDegreesPerRadian = 180.0 / M_PI;

}  // namespace markservo::geometry
