#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace markservo::campaign {

// When a recording's folder has something to read: {"moments": [us, ...], "events": number, "parts": number, "error":
// text}; a moment is a tenth of a second of event time that holds one event at least. Reads on after a damaged place.
nlohmann::json scan_recording(const std::string& folder);

}  // namespace markservo::campaign
