#pragma once

// How far the grip point is from its goal, by the simulator's truth, when the fingers begin to close, and how many
// frames servoing took to come there.

#include <Eigen/Core>
#include <cstdint>
#include <markservo/SimTruth.hpp>
#include <markservo/TaskState.hpp>
#include <optional>
#include <string>
#include <utility>

#include "tests/experiments/lift_truth.hpp"

namespace markservo::experiments {

struct Aim {
  int frames = 0;                        // of servoing, in the last attempt
  std::optional<Eigen::Vector3d> error;  // m, in C, true grip point minus its true goal; nothing: nothing was gripped
};

class AimWatch {
 public:
  // `p_TG`: m, in the axes of C, the grip point's goal from the mark `target`.
  AimWatch(std::string target, Eigen::Vector3d p_TG) : target_(std::move(target)), p_TG_(std::move(p_TG)) {}

  // One frame's truth, and the task's state at that frame. Another attempt counts alone.
  void observe(const SimTruth& truth, std::int8_t state) {
    if (state == TaskState::APPROACH) aim_ = Aim();
    if (state == TaskState::SERVO) ++aim_.frames;
    const auto p_CT = true_mark(truth, target_);
    if (state == TaskState::GRIP && state_ != TaskState::GRIP && p_CT) {
      aim_.error = vector(truth.p_CG) - (*p_CT + p_TG_);
    }
    state_ = state;
  }

  const Aim& aim() const { return aim_; }

 private:
  std::string target_;
  Eigen::Vector3d p_TG_;
  std::int8_t state_ = TaskState::IDLE;
  Aim aim_;
};

}  // namespace markservo::experiments
