#pragma once

namespace markservo {

// How base-navigator stands with its goal, as BaseStatus.lcm numbers and explains it.
enum class BaseState { kHold, kDriving, kArrived, kBlocked, kLost, kStale, kStopped };

// The word for a person and for SERVICE_STATUS: "hold", "driving", ...
const char* name_of(BaseState state);

}  // namespace markservo
