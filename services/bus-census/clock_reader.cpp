#include "services/bus-census/clock_reader.hpp"

#include <sys/timex.h>

namespace markservo::bus_census {

bool clock_is_synchronised() {
  timex state{};  // modes = 0: only asks
  const int answer = adjtimex(&state);
  return answer >= 0 && answer != TIME_ERROR && (state.status & STA_UNSYNC) == 0;
}

}  // namespace markservo::bus_census
