#pragma once

#include <cstddef>
#include <lcm/lcm-cpp.hpp>
#include <string>
#include <utility>
#include <vector>

namespace markservo::test {

using LogEvents = std::vector<std::pair<std::string, std::string>>;  // channel, payload

// Every event of a log: what must be the same run after run. None of a log that cannot be read.
inline LogEvents events_of(const std::string& path) {
  LogEvents events;
  lcm::LogFile log(path, "r");
  while (const auto* event = log.good() ? log.readNextEvent() : nullptr) {
    events.emplace_back(event->channel,
                        std::string(static_cast<const char*>(event->data), static_cast<std::size_t>(event->datalen)));
  }
  return events;
}

}  // namespace markservo::test
