#pragma once

// Which of the world's steps are exposures: as even as whole steps allow, and the same in every run.

#include <cmath>
#include <cstdint>

namespace markservo::simulator {

class FrameSchedule {
 public:
  // `rate_hz` above 0 and at most 1 / `step_s`; `step_s` is the world's time step.
  FrameSchedule(double rate_hz, double step_s, std::int64_t first_step)
      : steps_per_frame_(1.0 / (rate_hz * step_s)), first_step_(first_step) {}

  // The step of the next exposure.
  std::int64_t next() const { return first_step_ + std::llround(static_cast<double>(count_) * steps_per_frame_); }

  void advance() { ++count_; }

 private:
  double steps_per_frame_;
  std::int64_t first_step_;
  std::int64_t count_ = 0;
};

}  // namespace markservo::simulator
