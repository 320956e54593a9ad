#pragma once

// The service around it: two buses in one thread.

#include <memory>
#include <string>

#include "common/bus/service.hpp"
#include "services/bus-bridge/crossing_options.hpp"
#include "services/bus-bridge/repeat_filter.hpp"

namespace markservo::bus_bridge {

// Passes the channels that `crossing` names between two buses, byte by byte, while both are polled.
class Bridge {
 public:
  // Both buses must outlive the bridge, and neither may be polled after it is gone.
  Bridge(bus::Bus& local, bus::Bus& link, const Crossing& crossing);
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;

 private:
  void pass(const std::string& channel, bus::Bus& from, bus::Bus& to);

  RepeatFilter repeats_;
  std::size_t largest_;
};

class BusBridgeNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void start(bus::Bus& bus) override;
  void run(bus::Bus& bus) override;

 private:
  Crossing crossing_;
  std::unique_ptr<bus::Bus> link_;
  std::unique_ptr<Bridge> bridge_;
};

}  // namespace markservo::bus_bridge
