#pragma once

// What the main() of a program on the bus that is no service does: its bus, its exit codes.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace markservo::bus {

// Adds --lcm-url (environment MARKSERVO_LCM_URL) for a bus that others are on, udpm:// only. `url` is the default.
void add_live_bus_option(CLI::App& app, std::string& url);

// Parses the command line and runs `run`, which returns the exit code. One line on standard error and, as for services,
// 2 for wrong options and for ConfigurationError, 3 for BusUnavailable, 1 for what nobody foresaw.
int run_tool(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

}  // namespace markservo::bus
