#pragma once

// How old an input may be, in the time of what it moves; too far ahead is as wrong as too far behind.

#include <cstdint>
#include <string>

namespace markservo::motion {

struct Freshness {
  const char* what;    // the input, as its channel is named
  const char* clock;   // whose time is "now", as its channel is named
  double older = 0.0;  // s it may be behind
  double newer = 0.0;  // s it may be ahead
};

// Empty when `utime` (us) is fresh at `now` (us), else words with both numbers: "SERVO_GOAL is 0.72 s older than
// JOINT_STATE; allowed: 0.60 s".
std::string why_not_fresh(const Freshness& rule, std::int64_t utime, std::int64_t now);

inline constexpr double kGoalAge_s = 0.6;  // goals are repeated at 5 Hz, so two repetitions may be lost
inline constexpr double kCommandAge_s =
    2.0;  // RESET, START, HOME: a person's word, repeated at 5 Hz until it is echoed
inline constexpr double kCommandLife_s = 0.3;  // a joint or base command: older or missing ones stop motion

}  // namespace markservo::motion
