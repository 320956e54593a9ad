#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/recorder/manifest/manifest.hpp"

namespace markservo::recorder {

// Where configuration comes from; all absolute.
struct ConfigurationSources {
  std::string config_dir;
  std::string robot_file;  // the one that the services use
  std::string project;
};

struct ConfigurationFile {
  std::string path;                 // as kept
  std::optional<std::string> text;  // nothing: it cannot be read
};

// What each of `files` (absolute, each once) is called in the manifest, in their order: config/... for one in the
// configuration's folder, its path in the project, or outside/NAME: only a path inside the project can be written back
// by whoever has the recording. No two get the same: the robot file before all others, and what another has taken is
// outside/NAME, outside/2/NAME ...
std::vector<std::string> kept_paths(const std::vector<std::string>& files, const ConfigurationSources& sources);

// The text and hash (SHA-256) of each file that can be read, one hash over these, the paths of the others, and which
// the robot's is (`robot_file`, as kept).
Json configuration_json(const std::vector<ConfigurationFile>& files, const std::string& robot_file);

}  // namespace markservo::recorder
