#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/logs/log_event.hpp"
#include "common/reflection/message_value.hpp"
#include "services/log-tool/time_steps.hpp"

namespace markservo::log_tool {

struct ChannelSummary {
  std::string channel;
  std::uint64_t fingerprint = 0;  // of the first message of a known type, else of the first
  std::string type;               // empty: unknown
  std::int64_t events = 0;
  std::int64_t bytes = 0;        // of the messages
  std::int64_t largest = 0;      // bytes of a message
  std::int64_t too_large = 0;    // messages that a bus by UDP loses (bus_limits.hpp)
  std::int64_t first_utime = 0;  // us, the logger's
  std::int64_t last_utime = 0;
  double longest_gap = 0.0;         // s between two events
  std::int64_t undecodable = 0;     // messages of a known type that cannot be decoded, and of no type
  std::int64_t other_types = 0;     // messages of another type
  std::int64_t time_reversals = 0;  // messages with an earlier utime than the one before, of the same session
  std::int64_t sessions = 0;
  std::optional<std::int64_t> lost;  // gaps in seq, of each session; nothing where the type has no session and seq

  double hz() const;
};

struct LogSummary {
  std::int64_t events = 0;
  std::int64_t first_utime = 0;  // us, the logger's
  std::int64_t last_utime = 0;
  TimeSteps steps;                       // real logs have times that go back
  std::vector<ChannelSummary> channels;  // by name

  double seconds() const;
  // What makes a log untrustworthy: messages that cannot be decoded.
  std::int64_t undecodable() const;
};

LogSummary summarise(const std::vector<logs::LogEvent>& events, const reflection::TypeCatalog& catalog);

}  // namespace markservo::log_tool
