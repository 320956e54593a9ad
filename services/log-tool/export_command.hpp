#pragma once

#include <string>
#include <vector>

#include "common/logs/log_event.hpp"
#include "common/reflection/type_catalog.hpp"

namespace markservo::log_tool {

// Writes CHANNEL.csv for each channel of a type of `types` into `folder`, which is made or must be empty, and each
// stereo frame's two images as CHANNEL/000001_left.png and CHANNEL/000001_right.png. A / in a channel becomes _, and
// what is no printable ASCII a ?; of two channels that would share a name the second gets a number. Returns what was
// written and left out, a line each. Throws LogFileError when a file cannot be written.
std::string export_events(const std::vector<logs::LogEvent>& events, const std::string& folder,
                          const reflection::TypeCatalog& types);

}  // namespace markservo::log_tool
