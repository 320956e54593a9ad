#pragma once

// Plays a log to a bus that others are on.

#include <optional>
#include <stdexcept>
#include <string>

#include "common/bus/bus_url.hpp"
#include "common/logs/log_files.hpp"

namespace markservo::log_tool {

// Somebody writes what would be played: a reader would hear both. Nothing was sent.
class BusInUse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct PlayOptions {
  std::string url = bus::kDefaultUrl;
  double speed = 1.0;                 // times the recorded pace, above 0
  std::string channels;               // ChannelPattern; empty: all
  bool sort = false;                  // by the events' times, in place of the log's order
  std::optional<double> longest_gap;  // s of the log that are waited at most where nothing was logged
  bool all = false;
  bool join = false;
  // For what is said: who says it, and what a person types to look into a log.
  std::string own_name = "log-tool";
  std::string log_command = "scripts/log";
};

// Plays what plan_of() lets through, at the recorded pace, until the end or a signal; says on standard output what is
// played and what is left out, and why, where the log's time goes back or nothing was logged for long, and while that
// lasts that it goes on. Listens for 1.2 s before. Throws BusInUse (never with `join`), BusUnavailable,
// and std::invalid_argument when nothing is left to play. False if the bus did not take some message, which is said on
// standard error.
bool play(const logs::LogSet& logs, const PlayOptions& options);

}  // namespace markservo::log_tool
