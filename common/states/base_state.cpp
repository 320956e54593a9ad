#include "common/states/base_state.hpp"

namespace markservo {

const char* name_of(BaseState state) {
  switch (state) {
    case BaseState::kHold:
      return "hold";
    case BaseState::kDriving:
      return "driving";
    case BaseState::kArrived:
      return "arrived";
    case BaseState::kBlocked:
      return "blocked";
    case BaseState::kLost:
      return "lost";
    case BaseState::kStale:
      return "stale";
    case BaseState::kStopped:
      return "stopped";
  }
  return "unknown";
}

}  // namespace markservo
