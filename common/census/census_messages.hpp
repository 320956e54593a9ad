#pragma once

// Messages as the census takes them.

#include <cstddef>
#include <cstdint>
#include <markservo/ServiceStatus.hpp>
#include <optional>
#include <string>

#include "common/census/census.hpp"

namespace markservo::census {

// What the first `size` of a message's `whole_size` bytes tell; `utime`: us, this host's wall clock when it came.
// Writer and seq are only told of our types, which begin with them; 64 bytes are enough for that.
Heard heard_of(const std::string& channel, const void* data, std::size_t size, std::size_t whole_size,
               std::int64_t utime);

// The SERVICE_STATUS in these bytes; nothing where they came on another channel, are none, are broken or break a rule
// of their type. Of one of another version who speaks is told, as waiting, with the reason.
std::optional<ServiceWord> word_in(const std::string& channel, const void* data, std::size_t size);

// What `status` says, as it came on `channel`.
ServiceWord word_of(const ServiceStatus& status, const std::string& channel);

}  // namespace markservo::census
