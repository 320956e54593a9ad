#include "services/log-tool/log_splice.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "services/log-tool/message_key.hpp"

namespace markservo::log_tool {

std::vector<logs::LogEvent> spliced(const std::vector<logs::LogEvent>& recorded,
                                    const std::vector<logs::LogEvent>& derived) {
  std::set<std::string, std::less<>> replaced;
  for (const logs::LogEvent& event : derived) replaced.emplace(event.channel);

  std::map<MessageKey, std::size_t> places;
  std::map<std::int64_t, std::size_t> last_with_utime;
  MessageKeys recorded_keys;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    if (replaced.count(recorded[i].channel) > 0) {
      places.emplace(recorded_keys.next(recorded[i]), i);
    } else {
      last_with_utime[message_utime(recorded[i])] = i;
    }
  }

  // (place in the recorded log, derived event), in the derived log's own order.
  std::vector<std::pair<std::size_t, const logs::LogEvent*>> insertions;
  MessageKeys derived_keys;
  std::size_t place = 0;
  for (const logs::LogEvent& event : derived) {
    const auto counterpart = places.find(derived_keys.next(event));
    if (counterpart != places.end()) {
      place = std::max(place, counterpart->second);
    } else if (const auto same_time = last_with_utime.find(message_utime(event)); same_time != last_with_utime.end()) {
      place = std::max(place, same_time->second);
    }
    insertions.emplace_back(place, &event);
  }

  std::vector<logs::LogEvent> result;
  result.reserve(recorded.size() + derived.size());
  auto insertion = insertions.begin();
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    if (replaced.count(recorded[i].channel) == 0) result.push_back(recorded[i]);
    for (; insertion != insertions.end() && insertion->first == i; ++insertion) {
      logs::LogEvent event = *insertion->second;
      event.utime = recorded[i].utime;
      result.push_back(event);
    }
  }
  for (; insertion != insertions.end(); ++insertion) result.push_back(*insertion->second);
  for (std::size_t i = 0; i < result.size(); ++i) result[i].number = static_cast<std::int64_t>(i);
  return result;
}

}  // namespace markservo::log_tool
