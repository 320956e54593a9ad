#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace markservo::recorder {

// What shall be recorded, how it is kept, and until when.
struct RecordingPlan {
  std::string lcm_url;
  bool frames = true;  // false: without the images
  std::string robot;   // this prefix of channels only; empty: all
  std::string note;    // for the manifest
  std::optional<std::int64_t> duration_s;
  std::optional<std::int64_t> split_mb;    // a new part whenever one has so many
  std::optional<std::int64_t> keep_parts;  // the newest so many only
  // A full disk harms whatever else works on this host.
  std::int64_t min_free_mb = 500;
};

}  // namespace markservo::recorder
