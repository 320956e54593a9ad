#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/logs/log_event.hpp"

namespace markservo::log_tool {

// Which events of a log are wanted.
struct EventChoice {
  std::optional<double> from;         // s after the log's first event
  std::optional<double> to;           // s, that instant not included
  std::vector<std::string> channels;  // see ChannelPattern; empty: all
  std::vector<std::string> without;   // taken out again
};

std::set<std::string> channels_of(const std::vector<logs::LogEvent>& events);

// Those events, in their order. Throws std::invalid_argument for a pattern that is none.
std::vector<logs::LogEvent> chosen(const std::vector<logs::LogEvent>& events, const EventChoice& choice);

}  // namespace markservo::log_tool
