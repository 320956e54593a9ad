#pragma once

namespace markservo {

// How visual-servo stands with its goal, as ServoStatus.lcm numbers and explains it.
enum class ServoState { kHold, kPosture, kServo, kConverged, kLost, kUnreachable, kStale, kStopped };

// The word for a person and for SERVICE_STATUS: "hold", "posture", ...
const char* name_of(ServoState state);

}  // namespace markservo
