#pragma once

#include <string>

namespace markservo::log_tool {

// Writes the configuration files that the recording in `recording` (a folder with a manifest.json) kept into `folder`,
// under the paths they had in the project. Returns what was written, a line each. Throws LogFileError for a folder
// without a manifest, a manifest that is none, a file that exists, and a path that would leave `folder`.
std::string extract_config(const std::string& recording, const std::string& folder);

}  // namespace markservo::log_tool
