#pragma once

#include <cstdint>
#include <markservo/TaskState.hpp>

#include "common/states/task_phase.hpp"

namespace markservo::experiments {

inline const char* task_state_name(std::int8_t state) {
  return state >= TaskState::IDLE && state <= TaskState::DRIVE ? name_of(static_cast<TaskPhase>(state)) : "unknown";
}

inline const char* task_state_words(std::int8_t state) {
  switch (state) {
    case TaskState::DRIVE:
      return "to where the target can be taken";
    case TaskState::LOOK:
      return "find the target, decide whether it can be taken";
    case TaskState::APPROACH:
      return "bring the hand into view";
    case TaskState::SERVO:
      return "by sight to the grip point";
    case TaskState::GRIP:
      return "close the gripper";
    case TaskState::LIFT:
      return "lift 12 mm";
    case TaskState::VERIFY:
      return "does the book come along?";
    case TaskState::LIFT_ON:
      return "it does: lift on";
    case TaskState::CARRY:
      return "to the side";
    case TaskState::RELEASE:
      return "put it down";
    case TaskState::GO_HOME:
      return "back to the home posture";
    case TaskState::HOLD_LIFTED:
      return "the book is held above its place";
    case TaskState::DONE:
      return "done";
    default:
      return "";
  }
}

inline const char* task_result_name(std::int8_t result) {
  switch (result) {
    case TaskState::RESULT_LIFTED:
      return "lifted";
    case TaskState::RESULT_REFUSED:
      return "refused";
    default:
      return "failed";
  }
}

}  // namespace markservo::experiments
