#pragma once

// A bus inside the test: on memq:// it hears what it sends itself, and nobody else does.

#include <chrono>
#include <cstdint>
#include <markservo/ServiceStatus.hpp>
#include <string>

#include "common/bus/bus.hpp"

namespace markservo::bus {

// Of a bus that says nothing by itself.
inline BusParameters memq_parameters(const std::string& service_name) {
  BusParameters parameters;
  parameters.urls = {"memq://", "memq://"};
  parameters.service_name = service_name;
  parameters.heartbeat = false;
  return parameters;
}

// A channel that the table does not have.
template <class M>
constexpr channels::Channel<M> made_up(const char* name) {
  return channels::Channel<M>(channels::Entry{name});
}

// Handles all that waits, and the answers to it.
inline void settle(Bus& bus) {
  for (int i = 0; i < 8; ++i) bus.poll(std::chrono::milliseconds(0));
}

// How many messages of `channel` were refused; -1 if it is not subscribed.
inline std::int64_t refused(const Bus& bus, const std::string& channel) {
  for (const ChannelStatus& one : bus.status().channels) {
    if (one.channel == channel) return one.refused;
  }
  return -1;
}

}  // namespace markservo::bus
