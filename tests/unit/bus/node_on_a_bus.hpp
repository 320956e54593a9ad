#pragma once

// A service's node on a bus inside the test, configured with the project's robot.yaml.

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <markservo/StopState.hpp>
#include <string>
#include <vector>

#include "common/bus/service.hpp"
#include "tests/unit/bus/memq_bus.hpp"

namespace markservo::bus {

inline constexpr char kRobotFile[] = MARKSERVO_SOURCE_DIR "/config/robot.yaml";

inline StopState stop_state(std::int64_t utime, const std::string& device, bool latched) {
  StopState stop{};
  stop.utime = utime;
  stop.device = device;
  stop.latched = latched ? 1 : 0;
  stop.reason = "test";
  return stop;
}

template <class Node>
class NodeOnABus : public ::testing::Test {
 protected:
  explicit NodeOnABus(const std::string& service_name) : bus_(memq_parameters(service_name)) {}

  // `options` as on a command line. Subscribe what the node answers after it: the node hears what waits first.
  void start_node(const std::string& options = "") {
    node_.add_options(app_);
    app_.parse(options, false);
    node_.configure(kRobotFile);
    node_.start(bus_);
  }

  // All that comes on `channel` from now on.
  template <class M>
  void collect(const channels::Channel<M>& channel, std::vector<M>& messages) {
    bus_.on_each(channel, [&messages](const M& message) { messages.push_back(message); });
  }

  // Publishes, and handles all that follows from it.
  template <class M>
  void tell(Publisher<M>& publisher, M message) {
    publisher.publish(message);
    settle(bus_);
  }

  CLI::App app_;
  Bus bus_;
  Node node_;
};

}  // namespace markservo::bus
