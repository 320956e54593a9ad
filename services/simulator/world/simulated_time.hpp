#pragma once

// Simulated time: whole steps of the world since an epoch. It never goes back.

#include <cstdint>

#include "services/simulator/model/time_step.hpp"

namespace markservo::simulator {

class SimulatedTime {
 public:
  // `epoch`: us.
  explicit SimulatedTime(std::int64_t epoch) : epoch_(epoch) {}

  void step() { ++steps_; }
  // Goes on by `us`, a multiple of the time step, without steps of the world.
  void leap(std::int64_t us) { steps_ += us / kTimeStep_us; }

  std::int64_t steps() const { return steps_; }
  std::int64_t elapsed_us() const { return steps_ * kTimeStep_us; }
  std::int64_t utime() const { return epoch_ + elapsed_us(); }  // us

 private:
  std::int64_t epoch_;
  std::int64_t steps_ = 0;
};

}  // namespace markservo::simulator
