#include "common/watch/watch_json.hpp"

#include <optional>

#include "common/reflection/message_json.hpp"
#include "common/reflection/type_catalog.hpp"

namespace markservo::watch {
namespace {

template <class T>
nlohmann::ordered_json or_null(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace

nlohmann::ordered_json watch_json(const BusWatch& watch, double seconds, double now) {
  auto channels = nlohmann::ordered_json::array();
  for (const auto& [channel, entry] : watch.channels()) {
    const ChannelFigures figures = entry.watch.figures(now);
    std::optional<std::string> type;
    std::optional<std::string> hash;
    if (!figures.type.empty()) type = figures.type;
    if (figures.fingerprint) hash = reflection::fingerprint_text(*figures.fingerprint);
    channels.push_back({{"channel", channel},
                        {"type", or_null(type)},
                        {"hash", or_null(hash)},
                        {"received", figures.received},
                        {"bytes", figures.bytes},
                        {"hz", or_null(figures.hz)},
                        {"bytes_per_second", or_null(figures.bytes_per_second)},
                        {"age_s", figures.age},
                        {"stale", figures.stale},
                        {"lost", or_null(figures.lost)},
                        {"undecodable", figures.undecodable},
                        {"writers", figures.writers},
                        {"sessions", figures.sessions}});
  }
  return {{"seconds", seconds}, {"channels", channels}, {"unwatched", watch.unwatched()}};
}

nlohmann::ordered_json message_json(const std::string& channel, const reflection::Fields& fields) {
  return {
      {"channel", channel}, {"type", reflection::shown_name(*fields.type)}, {"message", reflection::json_of(fields)}};
}

}  // namespace markservo::watch
