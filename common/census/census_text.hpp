#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "common/census/census.hpp"

namespace markservo::census {

// The report's services and channels: {"listened_s", "services": [...], "channels": [...]}. Sessions, hashes and types'
// fingerprints are text ("0x..."): JSON's numbers hold 53 bits. Text that is not UTF-8 is replaced where it is not.
nlohmann::ordered_json json_of(const Report& report);

// One service's word as --follow prints it: {"robot", "name", "host", "pid", "session", "state", "reason", "ready"}.
nlohmann::ordered_json json_of(const ServiceWord& word);

// A session from that text, "0x" and 1 to 16 hexadecimal digits; nothing for any other.
std::optional<std::int64_t> session_of(const std::string& text);

// Both as tables for a person, a line each, without control characters.
std::string table_of(const Report& report);

}  // namespace markservo::census
