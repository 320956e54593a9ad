#pragma once

#include <functional>
#include <utility>

#include "common/bus/bus.hpp"
#include "services/simulator/time/lockstep_barrier.hpp"

namespace markservo::simulator {

// Waits on the bus until a barrier is complete: as long as nobody ever answered, by sending again, since services may
// start in any order; later only until a time-out. This host's steady clock counts.
class AnswerWait {
 public:
  enum class Outcome {
    kAnswered,
    kTimedOut,
    kInterrupted,  // the world was reset
    kEnded,        // the service shall end
  };

  // `repeat` sends again what is to be answered; `interrupted` tells whether that no longer matters.
  AnswerWait(std::function<void()> repeat, std::function<bool()> interrupted)
      : repeat_(std::move(repeat)), interrupted_(std::move(interrupted)) {}

  // `timeout_s` above 0.
  Outcome run(bus::Bus& bus, const LockstepBarrier& barrier, double timeout_s);

 private:
  std::function<void()> repeat_;
  std::function<bool()> interrupted_;
  bool answered_once_ = false;
};

}  // namespace markservo::simulator
