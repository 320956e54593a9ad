#pragma once

#include <string>

#include "services/recorder/folder/recording_folder.hpp"
#include "services/recorder/recorder_options.hpp"
#include "services/recorder/signal_queue.hpp"

namespace markservo::recorder {

// The folder that the options ask for, by --out, --name or the time. Throws Refusal.
RecordingFolder new_folder_of(const RecorderOptions& options, SignalQueue& signals);

// One named by the time; waits while somebody else has taken the second. Throws Refusal.
RecordingFolder new_dated_folder(const std::string& logs_dir, SignalQueue& signals);

// A folder as a person would name it.
std::string shown(const std::string& folder, const RecorderOptions& options);

}  // namespace markservo::recorder
