#pragma once

// The time that a task takes. While no SERVO_STATUS comes no goal is repeated: when the last one has aged, arm and base
// have to hold, and nobody is late by the time from then on. So it does not count.

#include <cstdint>

namespace markservo::task_manager {

class TaskClock {
 public:
  // What the utime (us) of a step says against that of the step before.
  struct Tick {
    std::int64_t passed_over_us = 0;  // what does not count of a pause; 0: nothing
    bool set_back = false;            // what was timed until now would wait for the old time to come again
  };
  Tick advance(std::int64_t utime);

  // us of the task's time: of the step, and of a message with this utime. Only differences mean something.
  std::int64_t now() const { return at(utime_); }
  std::int64_t at(std::int64_t utime) const { return utime - passed_over_us_; }

 private:
  std::int64_t utime_ = 0;  // us, of the newest step; 0: none yet
  std::int64_t passed_over_us_ = 0;
};

}  // namespace markservo::task_manager
