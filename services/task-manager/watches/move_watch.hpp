#pragma once

// Whether the goal of one move has been reached, told from SERVO_STATUS and JOINT_STATE.

#include <cstdint>
#include <optional>
#include <string>

#include "services/task-manager/parameters.hpp"
#include "services/task-manager/plans/posture_path.hpp"
#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

struct MoveProgress {
  std::int64_t since = 0;             // us of the task's time, when its goal was first sent
  std::optional<std::int64_t> there;  // likewise, when it came to its end
};

enum class MoveState { kUnderWay, kDone, kFailed };

struct MoveReport {
  MoveState state = MoveState::kUnderWay;
  std::string reason;  // why failed
};

// `goal_id`: under which the move was sent; `now`: us of the task's time. A move is done when it was there for its
// dwell; it fails when visual-servo says unreachable or move_timeout passes.
MoveReport watch_move(const Move& move, std::int64_t goal_id, const Input& input, std::int64_t now,
                      const MotionParameters& parameters, MoveProgress& progress);

}  // namespace markservo::task_manager
