#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "services/task-manager/phases/phase_context.hpp"
#include "services/task-manager/plans/posture_path.hpp"
#include "services/task-manager/watches/move_watch.hpp"

namespace markservo::task_manager {

// The arm's moves one after the other, each a goal of its own.
class MoveSequence {
 public:
  MoveSequence() = default;
  explicit MoveSequence(std::vector<Move> moves) : moves_(std::move(moves)) {}

  // Sends the first move, if there is one.
  void begin(PhaseContext& context);

  // Sends the next move when one is done. Done at the end of the last one, and where there are none.
  MoveReport step(PhaseContext& context);

 private:
  void send(PhaseContext& context);

  std::vector<Move> moves_;
  std::size_t index_ = 0;  // of the move that is under way
  MoveProgress progress_;
};

}  // namespace markservo::task_manager
