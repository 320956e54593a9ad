#pragma once

// Messages that another program might send in the stack's place.

#include <cstdint>
#include <optional>
#include <string>

#include "tests/system/fault_campaign/bench.hpp"

namespace markservo::campaign {

// A message for `channel`: the stack's last one, else one made from nothing (a goal, a command, a request); nothing
// where neither is there.
std::optional<Bytes> sample_for(Bench& bench, const std::string& channel);

// The world's newest stamp, us.
std::int64_t world_now(const Bench& bench);

// Shifts all stamps by `shift` (us): every field whose name ends in "utime".
void shift_stamps(Bytes& message, std::int64_t shift);
// Sets the first field `name`; false where there is none.
bool set_integer(Bytes& message, const std::string& name, std::int64_t value);
std::optional<std::int64_t> get_integer(const Bytes& message, const std::string& name);
// Another robot's: places, angles and ways are off by `amount`.
void displace(Bytes& message, double amount);

template <class M>
Bytes encoded(const M& message) {
  Bytes bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

}  // namespace markservo::campaign
