#include "services/bus-census/clock_reader.hpp"

#include <sys/timex.h>
#include <unistd.h>

#include <chrono>

namespace markservo::bus_census {
namespace {

template <class Clock>
int64_t now_us() {
  return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now().time_since_epoch()).count();
}

}  // namespace

int64_t wall_clock_us() {
  return now_us<std::chrono::system_clock>();
}

int64_t steady_clock_us() {
  return now_us<std::chrono::steady_clock>();
}

bool clock_is_synchronised() {
  timex state{};  // modes = 0: only asks
  const int answer = adjtimex(&state);
  return answer >= 0 && answer != TIME_ERROR && (state.status & STA_UNSYNC) == 0;
}

std::string host_name() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace markservo::bus_census
