#pragma once

// How a drive stands, told from BASE_STATUS.

#include <cstdint>
#include <string>

#include "services/task-manager/parameters.hpp"
#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

// Times in us of the task's time.
struct DriveProgress {
  std::int64_t since = 0;     // when the goal was first sent
  std::int64_t answered = 0;  // when base-navigator last could say how the goal stands
  std::int64_t driving = 0;   // when nothing last was in its way
};

// The progress of a goal that is sent at `now`.
inline DriveProgress begin_of_drive(std::int64_t now) {
  return {now, now, now};
}

enum class DriveState {
  kUnderWay,
  kWaiting,  // blocked or lost, but not for too long
  kArrived,
  kFailed,
  kStopped,  // base-navigator obeys a STOP
};

struct DriveReport {
  DriveState state = DriveState::kUnderWay;
  std::string reason;  // what is waited for, why failed or stopped
};

// `goal_id`: under which the goal was sent; `now`: us of the task's time.
DriveReport watch_drive(std::int64_t goal_id, const Input& input, std::int64_t now, const DriveParameters& parameters,
                        DriveProgress& progress);

}  // namespace markservo::task_manager
