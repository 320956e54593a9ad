#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "common/reflection/message_value.hpp"
#include "common/watch/bus_watch.hpp"

namespace markservo::watch {

// {"seconds", "channels": [{"channel", "type" (null: not known), "hash", "received", "bytes", "hz", "bytes_per_second",
// "age_s", "stale", "lost", "undecodable", "writers", "sessions"}], "unwatched"}; null where a figure is not known.
nlohmann::ordered_json watch_json(const BusWatch& watch, double seconds, double now);

// {"channel", "type", "message"}, bytes by their number.
nlohmann::ordered_json message_json(const std::string& channel, const reflection::Fields& fields);

}  // namespace markservo::watch
