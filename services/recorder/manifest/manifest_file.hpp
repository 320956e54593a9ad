#pragma once

#include <string>

#include "services/recorder/manifest/manifest.hpp"

namespace markservo::recorder {

// Writes the folder's manifest.json, in one step, so that there always is a whole one. False where it cannot be
// written.
bool write_manifest(const std::string& folder, const Json& manifest);

// Reads it; null where there is none, or no JSON.
Json read_manifest(const std::string& folder);

// Where the folder's manifest stands.
std::string manifest_path(const std::string& folder);

// What a writer that was killed may have left of it besides.
void remove_unfinished_manifest(const std::string& folder);
void remove_manifest(const std::string& folder);

}  // namespace markservo::recorder
