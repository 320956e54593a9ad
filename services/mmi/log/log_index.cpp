#include "services/mmi/log/log_index.hpp"

#include <algorithm>
#include <markservo/channels.hpp>
#include <set>
#include <unordered_map>

#include "common/robot/configuration_error.hpp"
#include "services/mmi/scene/message_slots.hpp"

namespace markservo::mmi {
namespace {

// Channels on which many write by design: a message's source is told by its content.
bool has_keys(const std::string& channel) {
  static const std::set<std::string> keyed{channels::kStopState.name, channels::kServiceStatus.name,
                                           channels::kProcessStatus.name, channels::kRecorderStatus.name};
  return keyed.count(channel) != 0;
}

}  // namespace

LogIndex::LogIndex(const logs::LogSet& log, const std::string& prefix, const reflection::TypeCatalog& types) {
  const std::vector<logs::LogEvent> all = log.events();
  std::unordered_map<std::string_view, std::size_t> numbers;  // of `names_`, by the whole channel
  std::vector<std::size_t> channel_of;
  for (const logs::LogEvent& event : all) {
    if (event.channel.substr(0, prefix.size()) != prefix) continue;
    const auto [known, is_new] = numbers.try_emplace(event.channel, names_.size());
    if (is_new) names_.emplace_back(event.channel.substr(prefix.size()));
    events_.push_back({event.utime, nullptr, event.data});
    channel_of.push_back(known->second);
  }
  if (events_.empty()) {
    throw ConfigurationError("--robot: the log has no channel that begins with '" + prefix + "'");
  }
  // From here on names stay where they are.
  for (std::size_t i = 0; i < events_.size(); ++i) events_[i].channel = &names_[channel_of[i]];
  // A logger writes as it hears, a merged or damaged log in any order.
  std::stable_sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) { return a.at < b.at; });

  for (std::size_t i = 0; i < events_.size(); ++i) {
    const Event& event = events_[i];
    std::string key;
    if (has_keys(*event.channel)) key = key_of(types, {event.data.data, event.data.data + event.data.size});
    by_source_[{event.channel, std::move(key)}].push_back(i);
    if (*event.channel == channels::kStereoFrame.name) pictures_.push_back(i);
  }
}

std::size_t LogIndex::count_until(std::int64_t at) const {
  const auto after = std::upper_bound(events_.begin(), events_.end(), at,
                                      [](std::int64_t time, const Event& event) { return time < event.at; });
  return static_cast<std::size_t>(after - events_.begin());
}

std::vector<std::size_t> LogIndex::newest_of(std::size_t count) const {
  std::vector<std::size_t> newest;
  for (const auto& [source, numbers] : by_source_) {
    const auto after = std::lower_bound(numbers.begin(), numbers.end(), count);
    if (after != numbers.begin()) newest.push_back(*(after - 1));
  }
  std::sort(newest.begin(), newest.end());
  return newest;
}

}  // namespace markservo::mmi
