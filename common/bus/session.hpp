#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace markservo::bus {

// A random positive number, new at each start of a writer.
std::int64_t random_session();

// A positive number that depends on the log's content and the service's name only, so that replaying a log twice
// writes the same bytes.
std::int64_t replay_session(const std::string& log_path, const std::string& service_name);

// A positive number that depends on the service's name only: for a source that writes a log from files, so that the
// same files give the same bytes.
std::int64_t source_session(const std::string& service_name);

// 64-bit FNV-1a of `text`, continued from `seed`.
std::uint64_t fingerprint(std::string_view text, std::uint64_t seed = 14695981039346656037ULL);

}  // namespace markservo::bus
