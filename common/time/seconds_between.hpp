#pragma once

#include <cstdint>

namespace markservo {

// s, from one utime (us) to another; exact within 285 years of 1970. What is said on a bus may be any number: their
// difference need not fit an integer.
inline double seconds_between(std::int64_t from_utime, std::int64_t to_utime) {
  return (static_cast<double>(to_utime) - static_cast<double>(from_utime)) * 1e-6;
}

}  // namespace markservo
