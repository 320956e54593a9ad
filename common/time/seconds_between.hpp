#pragma once

#include <cstdint>

namespace markservo {

// s, from one utime (us) to another.
inline double seconds_between(std::int64_t from_utime, std::int64_t to_utime) {
  return static_cast<double>(to_utime - from_utime) * 1e-6;
}

}  // namespace markservo
