#include "tests/system/fault_campaign/world_clock.hpp"

#include <algorithm>
#include <iterator>

#include "common/time/seconds_between.hpp"

namespace markservo::campaign {
namespace {

constexpr double kToldAgain_s = 0.3;
constexpr double kLongestTick_s = 1.0;  // longer between two stamps: a clock was set, or the simulator was away

}  // namespace

void WorldClock::heard(std::int64_t t, std::int64_t utime) {
  if (ticks_.empty()) {
    ticks_.push_back({t, utime, 0.0});
    return;
  }
  const Tick& last = ticks_.back();
  double step = seconds_between(last.utime, utime);
  // The last exposure is told again in answer to a SIM_CONTROL: nothing passed.
  if (step < 0.0 && step > -kToldAgain_s) return;
  if (step < 0.0 || step > kLongestTick_s) step = std::clamp(seconds_between(last.t, t), 0.0, kLongestTick_s);
  ticks_.push_back({t, utime, last.seconds + step});
}

double WorldClock::at(std::int64_t t) const {
  const auto after = std::upper_bound(ticks_.begin(), ticks_.end(), t,
                                      [](std::int64_t time, const Tick& tick) { return time < tick.t; });
  return after == ticks_.begin() ? 0.0 : std::prev(after)->seconds;
}

}  // namespace markservo::campaign
