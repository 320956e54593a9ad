#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "common/logs/log_event.hpp"
#include "common/reflection/type_catalog.hpp"

namespace markservo::log_tool {

// What makes a message of one run the counterpart of another run's: its channel, its time (utime is the first field of
// every type of ours), and its place among those that share both.
using MessageKey = std::tuple<std::string, std::int64_t, int>;

// The utime of a message of ours, us; 0 where it has none. Of an unknown type what stands at that place, likely a time.
// Of another system's that `types` has: its first field, if that is an int64_t.
std::int64_t message_utime(const logs::LogEvent& event,
                           const reflection::TypeCatalog& types = reflection::TypeCatalog::ours());

// Gives each message of one run its key; to be asked in the run's order.
class MessageKeys {
 public:
  explicit MessageKeys(const reflection::TypeCatalog& types = reflection::TypeCatalog::ours()) : types_(types) {}

  MessageKey next(const logs::LogEvent& event);

 private:
  const reflection::TypeCatalog& types_;
  std::map<std::pair<std::string, std::int64_t>, int> seen_;
};

}  // namespace markservo::log_tool
