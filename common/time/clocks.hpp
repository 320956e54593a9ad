#pragma once

// This host's clocks, for the shell around the algorithms: these are told the time.

#include <chrono>
#include <cstdint>

namespace markservo {

template <class Clock>
std::int64_t microseconds_of() {
  return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now().time_since_epoch()).count();
}

// us since the epoch, by the wall clock, which may jump.
inline std::int64_t wall_clock_us() {
  return microseconds_of<std::chrono::system_clock>();
}

// us, by a clock that nobody sets.
inline std::int64_t steady_clock_us() {
  return microseconds_of<std::chrono::steady_clock>();
}

// s, by the same.
inline double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace markservo
