#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/stack-watch/lcm_datagram.hpp"

namespace markservo::stack_watch {

// A message as a datagram, numbered by its seq.
template <class Message>
std::vector<std::uint8_t> short_message_of(const Message& message, const std::string& channel) {
  std::vector<std::uint8_t> payload(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(payload.data(), 0, static_cast<int>(payload.size()));
  return short_message(static_cast<std::uint32_t>(message.seq), channel, payload);
}

}  // namespace markservo::stack_watch
