#pragma once

// LOOK: measures the target, and decides whether it can be taken from here.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "services/task-manager/phases/phase_context.hpp"
#include "services/task-manager/watches/lift_check.hpp"

namespace markservo::task_manager {

struct Transition;

class Look {
 public:
  static constexpr Phase kPhase = Phase::kLook;

  void begin(PhaseContext& context);
  std::optional<Transition> step(PhaseContext& context);

 private:
  Transition decide(PhaseContext& context) const;

  std::int64_t since_ = 0;  // us, begin of the phase
  std::int64_t seen_ = 0;   // us, when the target was last located
  MarkAverage target_;
};

}  // namespace markservo::task_manager
