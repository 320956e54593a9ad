#pragma once

// LIFT, VERIFY, LIFT_ON: a little at first, to see whether the object comes along with the hand.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "services/task-manager/phases/move_sequence.hpp"
#include "services/task-manager/watches/mark_pair.hpp"

namespace markservo::task_manager {

struct Transition;

class Lift {
 public:
  static constexpr Phase kPhase = Phase::kLift;

  explicit Lift(std::vector<Move> moves) : moves_(std::move(moves)) {}

  void begin(PhaseContext& context) { moves_.begin(context); }
  std::optional<Transition> step(PhaseContext& context);

 private:
  MoveSequence moves_;
};

class Verify {
 public:
  static constexpr Phase kPhase = Phase::kVerify;

  void begin(PhaseContext& context) { since_ = context.now(); }
  std::optional<Transition> step(PhaseContext& context);

 private:
  Transition judge(PhaseContext& context) const;

  std::int64_t since_ = 0;  // us, begin of the phase
  MarkPair marks_;
};

class LiftOn {
 public:
  static constexpr Phase kPhase = Phase::kLiftOn;

  explicit LiftOn(std::vector<Move> moves) : moves_(std::move(moves)) {}

  void begin(PhaseContext& context) { moves_.begin(context); }
  std::optional<Transition> step(PhaseContext& context);

 private:
  MoveSequence moves_;
};

}  // namespace markservo::task_manager
