#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace markservo::bus {

// Tasks that are done again and again, by a steady clock whose time the caller tells.
class Timers {
 public:
  using Time = std::chrono::steady_clock::time_point;

  // Calls `task` every `period`, first one period after `now`.
  void add(std::chrono::milliseconds period, std::function<void()> task, Time now);

  // How long it is until one is due, but no longer than `limit`.
  std::chrono::milliseconds until_next(std::chrono::milliseconds limit, Time now) const;

  // Calls those that are due. `complain` is told what one throws.
  void run(Time now, const std::function<void(const char* what)>& complain);

 private:
  struct Timer {
    std::chrono::milliseconds period;
    Time due;
    std::function<void()> task;
  };

  std::vector<Timer> timers_;
};

}  // namespace markservo::bus
