#pragma once

// manifest.json: what a recording is, how it was made and how it ended. It is whole from the beginning; gaps and the
// end are filled in later.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "services/recorder/folder/part_names.hpp"
#include "services/recorder/logger/logger_end.hpp"
#include "services/recorder/recording_plan.hpp"

namespace markservo::recorder {

using Json = nlohmann::ordered_json;

// {"utc": "2026-01-31T12:00:00Z", "utime": us since the epoch}
Json instant(std::int64_t utime);

// What is known when a recording begins.
struct ManifestBeginning {
  std::string name;  // of its folder
  std::int64_t start_utime = 0;
  std::string host;
  std::string lcm_version;
  Json source;         // the commit, and whether files differ from it; null: not known
  Json types;          // name: hash
  Json configuration;  // as configuration_json gives it
};

Json begun_manifest(const ManifestBeginning& beginning, const RecordingPlan& plan);

// Whether it is a manifest of ours, and whether its end is filled in.
bool is_manifest(const Json& json);
bool is_complete(const Json& manifest);

// Since `from_utime` nothing is recorded, for that reason. A thousand gaps are told one by one; after that the last one
// grows.
void begin_gap(Json* manifest, std::int64_t from_utime, const LoggerEnd& logger, const std::string& reason);
// Since `to_utime` it is recorded again.
void end_gap(Json* manifest, std::int64_t to_utime);

struct ManifestEnd {
  std::string ended_by;
  std::int64_t utime = 0;
  std::optional<int> logger_exit_code;  // nothing: nobody saw it
  std::string logger_said;
  std::vector<Part> parts;
  int parts_removed = 0;
  Json found;  // what log-tool info --json finds in the parts; null where it cannot tell
};

void complete(Json* manifest, const ManifestEnd& end);

// What `found` is where nothing was recorded.
Json nothing_found();

// The manifest as it stands in its file.
std::string manifest_text(const Json& manifest);

}  // namespace markservo::recorder
