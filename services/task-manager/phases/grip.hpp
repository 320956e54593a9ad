#pragma once

// GRIP: the hand closes around the object, and both marks are measured for what follows.

#include <cstdint>
#include <optional>

#include "services/task-manager/phases/move_sequence.hpp"
#include "services/task-manager/watches/mark_pair.hpp"

namespace markservo::task_manager {

struct Transition;

class Grip {
 public:
  static constexpr Phase kPhase = Phase::kGrip;

  void begin(PhaseContext& context);
  std::optional<Transition> step(PhaseContext& context);

 private:
  enum class Stage { kClosing, kMeasuring };

  std::optional<Transition> close(PhaseContext& context);
  std::optional<Transition> measure(PhaseContext& context);

  Stage stage_ = Stage::kClosing;
  MoveSequence closing_;
  std::int64_t since_ = 0;  // us, begin of the measurement
  MarkPair marks_;
};

}  // namespace markservo::task_manager
