#pragma once

// A service's node as it runs, on a bus inside the process: a fuzz target's messages take the way that real ones take.

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <markservo/ServiceStatus.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/service.hpp"

namespace markservo::fuzz {

// Any bytes, sent as they are.
struct Datagram {
  std::vector<std::uint8_t> bytes;
};

// A message's bytes; none if it cannot be sent.
template <class M>
std::vector<std::uint8_t> encoded(const M& message) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  if (message.encode(bytes.data(), 0, static_cast<int>(bytes.size())) < 0) return {};
  return bytes;
}

template <class Node>
class NodeOnBus {
 public:
  // What became of the messages on the channel that the node reads.
  struct Counts {
    std::int64_t accepted = 0;  // by the bus
    std::int64_t refused = 0;   // by the bus or by the node
  };

  // `channel` is what the node reads.
  explicit NodeOnBus(const channels::Entry& channel) : channel_(channel), bus_(parameters()) {
    spdlog::set_level(spdlog::level::off);
    CLI::App app;
    node_.add_options(app);
    app.parse(std::vector<std::string>{});
    node_.configure(MARKSERVO_SOURCE_DIR "/config/robot.yaml");
    node_.start(bus_);
  }

  bus::Bus& bus() { return bus_; }

  // Sends to the node and handles all that follows from it.
  void send(const Datagram& datagram) {
    bus_.publish_raw(channel_.name, datagram.bytes.data(), datagram.bytes.size());
    for (int i = 0; i < 2; ++i) bus_.poll(std::chrono::milliseconds(0));  // the message, then the answers
  }

  Counts counts() const {
    Counts counts;
    for (const auto& status : bus_.status().channels) {
      if (status.channel == channel_.name) counts = {status.received, status.refused};
    }
    return counts;
  }

 private:
  static bus::BusParameters parameters() {
    bus::BusParameters parameters;
    parameters.urls = {"memq://", "memq://"};
    parameters.heartbeat = false;
    return parameters;
  }

  channels::Entry channel_;
  bus::Bus bus_;
  Node node_;
};

}  // namespace markservo::fuzz
