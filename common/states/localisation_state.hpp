#pragma once

namespace markservo {

// What a ROBOT_POSE is worth, as RobotPose.lcm numbers and explains it.
enum class LocalisationState { kSearching, kLocalised, kLost };

// The word for a person and for SERVICE_STATUS: "searching", "localised", "lost".
const char* name_of(LocalisationState state);

}  // namespace markservo
