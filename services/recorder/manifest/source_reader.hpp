#pragma once

#include <string>
#include <vector>

#include "services/recorder/folder/recording_folder.hpp"
#include "services/recorder/manifest/manifest.hpp"

namespace markservo::recorder {

// The commit of the project that is checked out in `project`, and whether files differ from it; null where git knows
// none.
Json source_version(const std::string& project);

// Name and hash of every message type that this build knows.
Json message_types();

// The version of Debian's package with lcm-logger; empty where dpkg knows none.
std::string lcm_version();

struct ReadConfiguration {
  Json kept;                            // as configuration_json has it
  std::vector<std::string> unreadable;  // files and folders, absolute
};

// All files in `config_dir` and its folders that are smaller than 1 MiB, and `robot_file`.
ReadConfiguration read_configuration(const std::string& config_dir, const std::string& robot_file,
                                     const std::string& project);

// What log-tool finds in a recording: log-tool info --json; null where it cannot tell. Ctrl-C does not end it.
Json found_in(const RecordingFolder& folder);

}  // namespace markservo::recorder
