#pragma once

// Between messages and the procedure's own structs.

#include <cstdint>
#include <markservo/channels.hpp>
#include <vector>

#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

Command command_of(const TaskCommand& message);

std::vector<MarkReport> mark_reports(const TargetPose& message);

// Throws std::invalid_argument unless it has the arm's number of joints.
ArmReport arm_report(const JointState& message);

// `goal_session`: ours, of the goals that are answered. The id of another one's goal is 0.
BaseReport base_report(const BaseStatus& message, std::int64_t goal_session);
ServoReport servo_report(const ServoStatus& message, std::int64_t goal_session);

// The answers to `status`. Of ServoGoal and TaskState session and seq are the publisher's to fill.
ServoGoal servo_goal_message(const Goal& goal, const ServoStatus& status);
BaseGoal base_goal_message(const DriveGoal& goal, const ServoStatus& status, std::int64_t session);
TaskState task_state_message(const Output& output, const ServoStatus& status);

}  // namespace markservo::task_manager
