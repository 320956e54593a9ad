#pragma once

// What the phases of a task work with at one step.

#include <cstdint>
#include <string>
#include <vector>

#include "services/task-manager/goals.hpp"
#include "services/task-manager/parameters.hpp"
#include "services/task-manager/procedure_types.hpp"
#include "services/task-manager/task.hpp"
#include "services/task-manager/task_clock.hpp"
#include "services/task-manager/watches/holding.hpp"

namespace markservo::task_manager {

struct PhaseContext {
  const robot::RobotDescription& robot;
  const Parameters& parameters;
  const Input& input;
  const TaskClock& clock;
  Task& task;
  Holding& holding;
  ArmGoals& arm_goals;
  BaseGoals& base_goals;
  std::string& reason;                // told with the phase: why, or what is waited for
  std::vector<std::string>& notices;  // for the log

  std::int64_t now() const { return clock.now(); }     // us of the task's time
  double seconds_since(std::int64_t task_time) const;  // until now

  // Who has no arm, no hand's mark, or no grip for the target begins no task: see guards.hpp.
  const robot::ArmDescription& arm() const { return *robot.arm; }
  const robot::MarkDescription& target() const { return *robot.find_mark(task.command.target); }
  const robot::GripDescription& grip() const { return *target().grip; }

  MarkReport target_mark() const;
  MarkReport hand_mark() const;
  // Which of both is not located, and what is seen of it.
  std::string describe_unseen() const;

  double closed() const;      // m, what the gripper is told to close to around the target
  double grip_force() const;  // N
};

// Tells the arm to stay where it is, the gripper as it is reported, so that no reset makes it go on; one that holds
// something keeps pressing. After a restart it is unknown whether it does: a hand that is not open stays closed with
// the grip's force until HOME or START opens it. Nothing is told while nothing is known that could be kept.
void hold_arm(PhaseContext& context);

}  // namespace markservo::task_manager
