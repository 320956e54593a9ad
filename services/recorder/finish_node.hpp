#pragma once

#include "services/recorder/recorder_options.hpp"

namespace markservo::recorder {

// Completes the manifest of the recording in options.finish, whose recorder was killed. Throws Refusal.
void finish_recording(const RecorderOptions& options);

}  // namespace markservo::recorder
