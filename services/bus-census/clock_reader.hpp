#pragma once

#include <cstdint>
#include <string>

namespace markservo::bus_census {

// us since the epoch, by this host's wall clock.
int64_t wall_clock_us();

// us, by a clock that nobody sets.
int64_t steady_clock_us();

// Whether the kernel's clock is disciplined by NTP or PTP (whichever program does it), by adjtimex(2).
bool clock_is_synchronised();

std::string host_name();

}  // namespace markservo::bus_census
