#pragma once

// CARRY: out of its row with the object, over the side table and down.

#include <optional>
#include <utility>
#include <vector>

#include "services/task-manager/phases/move_sequence.hpp"

namespace markservo::task_manager {

struct Transition;

class Carry {
 public:
  static constexpr Phase kPhase = Phase::kCarry;

  explicit Carry(std::vector<Move> moves) : moves_(std::move(moves)) {}

  void begin(PhaseContext& context);
  std::optional<Transition> step(PhaseContext& context);

 private:
  MoveSequence moves_;
};

}  // namespace markservo::task_manager
