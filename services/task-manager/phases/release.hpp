#pragma once

// RELEASE and GO_HOME: the hand lets go and leaves, and the arm folds.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "services/task-manager/phases/move_sequence.hpp"

namespace markservo::task_manager {

struct Transition;

class Release {
 public:
  static constexpr Phase kPhase = Phase::kRelease;

  // What follows.
  enum class Then { kLookAgain, kFail, kGoHome, kGoHomeCarried };

  // `failure`: why the hand lets go, where that leads to another look or to the task's failure.
  Release(std::vector<Move> moves, Then then, std::string failure = "")
      : moves_(std::move(moves)), then_(then), failure_(std::move(failure)) {}

  void begin(PhaseContext& context) { moves_.begin(context); }
  std::optional<Transition> step(PhaseContext& context);

 private:
  Transition look_again(PhaseContext& context) const;
  Transition go_home(PhaseContext& context) const;

  MoveSequence moves_;
  Then then_;
  std::string failure_;
};

class GoHome {
 public:
  static constexpr Phase kPhase = Phase::kGoHome;

  // `carried`: the object stands on the side table.
  GoHome(std::vector<Move> moves, bool carried) : moves_(std::move(moves)), carried_(carried) {}

  void begin(PhaseContext& context) { moves_.begin(context); }
  std::optional<Transition> step(PhaseContext& context);

 private:
  MoveSequence moves_;
  bool carried_;
};

}  // namespace markservo::task_manager
