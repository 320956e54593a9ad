#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "services/log-tool/log_event.hpp"

namespace markservo::log_tool {

// What makes a message of one run the counterpart of another run's: its channel, its utime (the first field of every
// type of ours), and its place among those that share both.
using MessageKey = std::tuple<std::string, std::int64_t, int>;

// The utime of a message of ours, us; 0 where it has none.
std::int64_t message_utime(const Event& event);

// Gives each message of one run its key; to be asked in the run's order.
class MessageKeys {
 public:
  MessageKey next(const Event& event);

 private:
  std::map<std::pair<std::string, std::int64_t>, int> seen_;
};

}  // namespace markservo::log_tool
