#pragma once

// The phases in which no task is under way: what was, has come to an end, and the next command is waited for.

#include "services/task-manager/phases/phase_context.hpp"

namespace markservo::task_manager {

struct AtRest {
  void begin(PhaseContext&) {}
};

struct Idle : AtRest {
  static constexpr Phase kPhase = Phase::kIdle;
};

// The object is held above its place.
struct HoldLifted : AtRest {
  static constexpr Phase kPhase = Phase::kHoldLifted;
};

// Carried, or home.
struct Done : AtRest {
  static constexpr Phase kPhase = Phase::kDone;
};

// Nothing has moved towards the target.
struct Refused : AtRest {
  static constexpr Phase kPhase = Phase::kRefused;
};

// Tried, and given up: the arm stays where it is.
struct Failed : AtRest {
  static constexpr Phase kPhase = Phase::kFailed;
  void begin(PhaseContext& context) { hold_arm(context); }
};

// Ended by STOP or ABORT, or because it may not go on: the arm stays where it is too.
struct Stopped : AtRest {
  static constexpr Phase kPhase = Phase::kStopped;
  void begin(PhaseContext& context) { hold_arm(context); }
};

}  // namespace markservo::task_manager
