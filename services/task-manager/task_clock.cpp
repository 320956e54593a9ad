#include "services/task-manager/task_clock.hpp"

#include <utility>

#include "common/motion/freshness.hpp"
#include "common/time/seconds_between.hpp"

namespace markservo::task_manager {

TaskClock::Tick TaskClock::advance(std::int64_t utime) {
  constexpr double kSetBack_s = 1.0;
  constexpr auto kGoalAge_us = static_cast<std::int64_t>(1e6 * motion::kGoalAge_s);
  const std::int64_t before = std::exchange(utime_, utime);
  Tick tick;
  if (before != 0 && utime - before > kGoalAge_us) tick.passed_over_us = utime - before - kGoalAge_us;
  tick.set_back = seconds_between(utime, before) > kSetBack_s;
  passed_over_us_ = tick.set_back ? 0 : passed_over_us_ + tick.passed_over_us;
  return tick;
}

}  // namespace markservo::task_manager
