#pragma once

// The task's procedure (paper fig. 11) as a state machine: one step per SERVO_STATUS, time from its utime. Which phase
// follows which is declared in common/task/transitions.hpp. In every step the watches come first, then the commands,
// then the phase; each may end it and begin another one.

#include <string>

#include "common/motion/command_inbox.hpp"
#include "services/task-manager/goals.hpp"
#include "services/task-manager/parameters.hpp"
#include "services/task-manager/phases/active_phase.hpp"
#include "services/task-manager/procedure_types.hpp"
#include "services/task-manager/task.hpp"
#include "services/task-manager/task_clock.hpp"
#include "services/task-manager/watches/arm_session.hpp"
#include "services/task-manager/watches/holding.hpp"
#include "services/task-manager/watches/servo_watch.hpp"
#include "services/task-manager/watches/stop_watch.hpp"

namespace markservo::task_manager {

// All that is kept from step to step.
struct State {
  ActivePhase phase;
  std::string reason = "started: no task";
  Task task;
  motion::CommandInbox inbox{"TASK_COMMAND", "JOINT_STATE"};
  ArmGoals arm_goals;
  BaseGoals base_goals;
  TaskClock clock;

  // Watched in any phase.
  ArmSession arm;
  StopWatch stops;
  ServoWatch servo;
  Holding holding;
};

class Procedure {
 public:
  Procedure(robot::RobotDescription robot, Parameters parameters);
  Output step(const Input& input, State& state) const;

 private:
  robot::RobotDescription robot_;
  Parameters parameters_;
};

}  // namespace markservo::task_manager
