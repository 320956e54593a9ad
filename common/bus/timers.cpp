#include "common/bus/timers.hpp"

#include <algorithm>
#include <exception>
#include <utility>

namespace markservo::bus {

using std::chrono::milliseconds;

void Timers::add(milliseconds period, std::function<void()> task, Time now) {
  timers_.push_back({period, now + period, std::move(task)});
}

milliseconds Timers::until_next(milliseconds limit, Time now) const {
  milliseconds wait = limit;
  for (const auto& timer : timers_) {
    wait = std::min(wait, std::chrono::ceil<milliseconds>(std::max(timer.due - now, Time::duration::zero())));
  }
  return wait;
}

void Timers::run(Time now, const std::function<void(const char* what)>& complain) {
  for (auto& timer : timers_) {
    if (timer.due > now) continue;
    timer.due = now + timer.period;
    try {
      timer.task();
    } catch (const std::exception& error) {
      complain(error.what());
    }
  }
}

}  // namespace markservo::bus
