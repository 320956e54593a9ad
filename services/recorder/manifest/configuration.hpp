#pragma once

#include <string>
#include <vector>

#include "services/recorder/manifest/manifest.hpp"

namespace markservo::recorder {

struct ConfigurationFile {
  std::string path;  // as kept
  std::string text;
};

// What a file is called in the manifest: config/... for one in the configuration's folder, its path in the project, or
// outside/NAME: only a path inside the project can be written back by whoever has the recording. All three absolute.
std::string kept_path(const std::string& file, const std::string& config_dir, const std::string& project);

// The text and hash (SHA-256) of each file, and one hash over all.
Json configuration_json(const std::vector<ConfigurationFile>& files);

}  // namespace markservo::recorder
