#pragma once

// What operators' programs say and hear: a dialogue's wish as a message, TASK_STATE as a dialogue takes it.

#include <cstdint>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>

#include "common/messages/state_codes.hpp"
#include "common/motion/command_sender.hpp"
#include "common/task/dialogue.hpp"

namespace markservo::messages {

// By which rule of time it is sent.
inline motion::CommandKind command_kind(task::Action action) {
  switch (action) {
    case task::Action::kStart:
      return motion::CommandKind::kStart;
    case task::Action::kHome:
      return motion::CommandKind::kHome;
    case task::Action::kDrive:
      return motion::CommandKind::kDrive;
    case task::Action::kAbort:
      return motion::CommandKind::kAbort;
    case task::Action::kReset:
      return motion::CommandKind::kReset;
    case task::Action::kStop:
      break;
  }
  return motion::CommandKind::kStop;
}

// TaskCommand.kind; of what is said as STOP, ABORT.
inline std::int8_t task_command_kind(task::Action action) {
  switch (action) {
    case task::Action::kStart:
      return TaskCommand::START;
    case task::Action::kHome:
      return TaskCommand::HOME;
    case task::Action::kDrive:
      return TaskCommand::DRIVE;
    default:
      return TaskCommand::ABORT;
  }
}

// `is_ours`: it answers the command that is meant.
inline task::TaskReport task_report(const TaskState& state, bool is_ours) {
  task::TaskReport report;
  report.time = 1e-6 * static_cast<double>(state.utime);
  report.answers = is_ours                      ? task::Answers::kUs
                   : state.command_session != 0 ? task::Answers::kAnother
                                                : task::Answers::kNobody;
  report.phase = state_of<task::Phase>(state.state);
  report.attempt = state.attempt;
  report.target = state.target;
  report.reason = state.reason;
  return report;
}

}  // namespace markservo::messages
