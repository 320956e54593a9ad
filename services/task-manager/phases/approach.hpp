#pragma once

// APPROACH: the open hand goes to a posture before the target, until its mark is seen.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "services/task-manager/phases/move_sequence.hpp"

namespace markservo::task_manager {

struct Transition;

class Approach {
 public:
  static constexpr Phase kPhase = Phase::kApproach;

  explicit Approach(std::vector<Move> moves) : moves_(std::move(moves)) {}

  void begin(PhaseContext& context) { moves_.begin(context); }
  std::optional<Transition> step(PhaseContext& context);

 private:
  enum class Stage { kOnTheWay, kWaitingForTheHand };

  std::optional<Transition> wait_for_the_hand(PhaseContext& context);

  Stage stage_ = Stage::kOnTheWay;
  MoveSequence moves_;
  std::int64_t since_ = 0;       // us, begin of the wait
  std::int64_t pose_utime_ = 0;  // us, of the newest frame that was looked at
  int hand_frames_ = 0;          // the hand's mark located in so many in a row
};

}  // namespace markservo::task_manager
