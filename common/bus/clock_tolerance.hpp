#pragma once

#include <cstdint>

namespace markservo::bus {

// Hosts' clocks agree within 5 ms; what is stamped further ahead than this is wrong, and refused.
inline constexpr std::int64_t kClockTolerance_us = 20'000;

}  // namespace markservo::bus
