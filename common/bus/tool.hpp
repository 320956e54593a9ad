#pragma once

// What the main() of a program on the bus that is no service does: its bus, its exit codes.

#include <functional>
#include <string>

#include "common/bus/options.hpp"

namespace markservo::bus {

struct ToolInfo {
  std::string name;         // of the executable
  std::string description;  // one line for --help
};

// Adds --lcm-url (named_bus.hpp) for a bus that others are on, udpm:// only. `url` is the default.
void add_live_bus_option(CLI::App& app, std::string& url);

// Parses the command line by the options that `add_options` adds, and runs `run`, which returns the exit code. One line
// on standard error and, as for services, 2 for wrong options and for ConfigurationError, 3 for BusUnavailable, 1 for
// what nobody foresaw.
int run_tool(const ToolInfo& info, int argc, char** argv, const std::function<void(CLI::App& app)>& add_options,
             const std::function<int()>& run);

}  // namespace markservo::bus
