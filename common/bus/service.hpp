#pragma once

// What every service's main() does: options, configuration, bus, signals, exit codes.

#include <optional>
#include <string>

#include "common/bus/bus.hpp"
#include "common/bus/exit_code.hpp"
#include "common/bus/options.hpp"

namespace markservo::bus {

struct ServiceInfo {
  std::string name;         // of the executable
  std::string description;  // one line for --help: what it reads and writes
};

// A service: the pure algorithm's thin shell. Called in this order.
class Service {
 public:
  virtual ~Service() = default;

  // Adds the service's own options, by Options or as CLI11 does; names are flat and dashed, so that --config FILE can
  // set them.
  virtual void add_options(CLI::App& app) = 0;

  // Reads files and checks settings, before any bus. `robot_file` is --robot-file. Throws ConfigurationError.
  virtual void configure(const std::string& robot_file) = 0;

  // What --check does: as configure(), but without taking a device that a running service may hold.
  virtual void check(const std::string& robot_file) { configure(robot_file); }

  // False for a source that only writes: then writing a log needs no bus to read, and is the same in every run.
  virtual bool reads_bus() const { return true; }

  // True if a network that is missing, at the start or later, is waited for; false for what a person waits for himself.
  virtual bool waits_for_network() const { return true; }

  // Work that needs no bus (a picture, a snapshot, a log): the exit code ends the program; nothing goes on to the bus.
  // `robot` is --robot.
  virtual std::optional<int> run_alone(const std::string& /*robot*/) { return std::nullopt; }

  // Subscribes and advertises. Throws ConfigurationError.
  virtual void start(Bus& bus) = 0;

  // Runs until the bus says stop; a service with a loop of its own calls bus.poll() in it.
  virtual void run(Bus& bus) { bus.spin(); }
};

// Common options: --config, --print-config, --check, --list-channels, --robot-file (environment MARKSERVO_ROBOT_FILE),
// --robot, --lcm-url (environment MARKSERVO_LCM_URL, else LCM_DEFAULT_URL), --lcm-in, --lcm-out, --log-level. Returns
// the exit code: 0 stopped, 1 failed, 2 bad configuration, 3 bus unavailable.
int run_service(const ServiceInfo& info, Service& service, int argc, char** argv);

}  // namespace markservo::bus
