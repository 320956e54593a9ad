#include "common/states/servo_state.hpp"

namespace markservo {

const char* name_of(ServoState state) {
  switch (state) {
    case ServoState::kHold:
      return "hold";
    case ServoState::kPosture:
      return "posture";
    case ServoState::kServo:
      return "servo";
    case ServoState::kConverged:
      return "converged";
    case ServoState::kLost:
      return "lost";
    case ServoState::kUnreachable:
      return "unreachable";
    case ServoState::kStale:
      return "stale";
    case ServoState::kStopped:
      return "stopped";
  }
  return "unknown";
}

}  // namespace markservo
