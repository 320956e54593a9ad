#pragma once

#include <string>

#include "services/recorder/manifest/manifest.hpp"

namespace markservo::recorder {

// How long nothing was recorded, and why: "1.25 s are missing (lcm-logger was killed by signal 9 (SIGKILL))".
std::string told_of_gaps(const Json& manifest);

// One line of what is in a completed recording. `log_command` is what a person types to look into one.
std::string told_of_recording(const Json& manifest, const std::string& log_command);

}  // namespace markservo::recorder
