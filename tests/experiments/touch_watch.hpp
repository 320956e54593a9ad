#pragma once

// What the arm touched first in a task, by the simulator's truth, and in which phase.

#include <cstdint>
#include <markservo/SimTruth.hpp>
#include <optional>
#include <string>

namespace markservo::experiments {

class TouchWatch {
 public:
  // `phase`: the task's state when the truth was heard.
  void observe(const SimTruth& truth, std::int8_t phase) {
    if (!truth.arm_touched) return;
    if (!since_) {
      since_ = truth.utime;
      touched_ = truth.touched;
    }
    if (truth.utime - *since_ <= kPhaseKnown_us) phase_ = phase;
  }

  // As "finger_left - book_middle"; empty while nothing was touched.
  const std::string& touched() const { return touched_; }
  // The task's state then.
  std::optional<std::int8_t> phase() const { return phase_; }

 private:
  // From a change of phase until it is told for certain, where a link loses one message in five.
  static constexpr std::int64_t kPhaseKnown_us = 300'000;

  std::optional<std::int64_t> since_;
  std::string touched_;
  std::optional<std::int8_t> phase_;
};

}  // namespace markservo::experiments
