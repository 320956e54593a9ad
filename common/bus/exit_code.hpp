#pragma once

// What services and tools end with.

namespace markservo::bus {

inline constexpr int kExitStopped = 0;
inline constexpr int kExitFailed = 1;  // what nobody foresaw
inline constexpr int kExitBadConfiguration = 2;
inline constexpr int kExitBusUnavailable = 3;

}  // namespace markservo::bus
