#pragma once

namespace markservo::bus_census {

// Whether the kernel's clock is disciplined by NTP or PTP (whichever program does it), by adjtimex(2).
bool clock_is_synchronised();

}  // namespace markservo::bus_census
