#pragma once

// The phase that a task is in, with the memory of that phase alone, and the change to another one.

#include <optional>
#include <string>
#include <variant>

#include "services/task-manager/phases/approach.hpp"
#include "services/task-manager/phases/at_rest.hpp"
#include "services/task-manager/phases/carry.hpp"
#include "services/task-manager/phases/drive.hpp"
#include "services/task-manager/phases/grip.hpp"
#include "services/task-manager/phases/lift.hpp"
#include "services/task-manager/phases/look.hpp"
#include "services/task-manager/phases/release.hpp"
#include "services/task-manager/phases/servo.hpp"

namespace markservo::task_manager {

using ActivePhase = std::variant<Idle, Drive, Look, Approach, Servo, Grip, Lift, Verify, LiftOn, Carry, Release, GoHome,
                                 HoldLifted, Done, Refused, Failed, Stopped>;

struct Transition {
  ActivePhase next;
  std::string reason;  // told with it
};

Phase phase_of(const ActivePhase& phase);

// What is done as the phase is entered.
void begin(ActivePhase& phase, PhaseContext& context);

// One step of the phase, at a SERVO_STATUS: the phase that follows, if one does. Phases at rest wait for commands.
std::optional<Transition> step(ActivePhase& phase, PhaseContext& context);

}  // namespace markservo::task_manager
