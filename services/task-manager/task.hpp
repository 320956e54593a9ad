#pragma once

// The task: what was asked for, what was found out, and what became of it.

#include <string>

#include "services/task-manager/plans/pick_plan.hpp"
#include "services/task-manager/procedure_types.hpp"
#include "services/task-manager/watches/lift_check.hpp"

namespace markservo::task_manager {

struct Task {
  Command command;  // the last START or DRIVE
  int attempt = 0;  // 1 for the first grip
  Result result = Result::kNone;
  std::string failure;  // of the first grip: told when there can be no second one
  bool driven = false;  // the base was told to drive for it
  int corrections = 0;  // drives after the first
  GripPlace place;      // where LOOK found it
  LiftView at_grip;     // both marks, and the arm, before the lift
};

// What is under way, for people: what it takes, or that it drives.
std::string subject_of(const Command& command);

// The result of a task that had `so_far` in phase `left` and comes to `entered`.
Result result_after(Phase left, Phase entered, Result so_far);

}  // namespace markservo::task_manager
