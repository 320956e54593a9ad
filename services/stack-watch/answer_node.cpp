// What the watch tells scripts/stack status.

#include <unistd.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "common/census/census_text.hpp"
#include "common/reflection/message_json.hpp"
#include "services/stack-watch/stack_watch_node.hpp"

namespace markservo::stack_watch {

using Json = nlohmann::ordered_json;

std::string StackWatchNode::answer() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Instant when = now();
  const census::Report report = recent_.report(when);
  Json json = {{"url", settings_.url}, {"host", word_.host()}, {"version", MARKSERVO_VERSION}};
  json.update(census::json_of(report));
  for (std::size_t i = 0; i < report.services.size(); ++i) {
    const auto since_us = recent_.state_since_us(report.services[i].newest);
    json["services"][i]["state_for_s"] = since_us ? Json(1e-6 * static_cast<double>(when.wall_us - *since_us)) : Json();
  }
  Json kills = Json::array();
  for (const Kill& each : kills_.newest()) {
    kills.push_back({{"name", each.name},
                     {"pid", each.pid},
                     {"silent_s", each.silent_s},
                     {"spoke", each.spoke},
                     {"utime", each.utime}});
  }
  Json services = Json::array();
  for (const RunningProcess& process : supervisor_.running()) {
    const std::int64_t silent_us = silence_.silent_for_us(process.name, process.pid, when.steady_us);
    services.push_back({{"name", process.name},
                        {"pid", process.pid},
                        {"silent_s", silent_us < 0 ? Json() : Json(1e-6 * static_cast<double>(silent_us))}});
  }
  json["watch"] = {{"pid", getpid()},
                   {"bus", bus_.is_gone() ? Json("the bus is gone: " + bus_.problem()) : Json()},
                   {"bus_changed_utime", bus_.changed_us()},
                   {"supervisor", supervisor_.is_alive()},
                   {"supervisor_changed_utime", supervisor_.changed_us()},
                   {"silence_limit_s", 1e-6 * static_cast<double>(silence_.limit_us())},
                   {"processes", services},
                   {"kills", kills},
                   {"crafted_fragments", crafted_.count()}};
  return reflection::json_text(json, -1);
}

}  // namespace markservo::stack_watch
