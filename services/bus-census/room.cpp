#include "services/bus-census/room.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <markservo/channels.hpp>

#include "common/reflection/value_text.hpp"

namespace markservo::bus_census {
namespace {

using census::ChannelReport;
using census::Report;
using census::ServiceReport;
using census::ServiceWord;
using census::WriterReport;

constexpr const char* kUnknown = "a program that does not say who it is";

// The first channel that `service` alone may write; null: it may be started beside another.
const channels::Entry* channel_of_its_own(const std::string& service) {
  for (const channels::Entry& entry : channels::kAll) {
    if (entry.second != channels::Second::kAllowed && channels::has(entry.writers, service)) return &entry;
  }
  return nullptr;
}

bool shall_write(const RoomWish& wish, const std::string& channel) {
  const channels::Entry* entry = channels::find(channel.substr(channel.rfind('/') + 1));
  if (entry == nullptr || entry->second == channels::Second::kAllowed) return false;
  return std::any_of(wish.services.begin(), wish.services.end(),
                     [entry](const std::string& service) { return channels::has(entry->writers, service); });
}

bool is_its_robot(const RoomWish& wish, const std::string& robot) {
  return !wish.robot || *wish.robot == robot;
}

bool is_own(const RoomWish& wish, const ServiceWord& word) {
  return word.host == wish.host && wish.own.count(word.pid) > 0;
}

std::string who(const ServiceWord& word) {
  return word.name + " (process " + std::to_string(word.pid) + " on " + word.host + ")";
}

// The newest word of the process that writes with this session, one of the wish's own if it is claimed by several;
// null: it has said none.
const ServiceWord* word_of(const Report& report, const RoomWish& wish, std::int64_t session) {
  const ServiceWord* word = nullptr;
  for (const ServiceReport& service : report.services) {
    if (service.newest.session != session) continue;
    if (word == nullptr || is_own(wish, service.newest)) word = &service.newest;
  }
  return word;
}

// The writers of a channel who are not the wish's own.
std::set<std::string> other_writers(const Report& report, const RoomWish& wish, const ChannelReport& channel) {
  if (channel.writers.empty()) return {kUnknown};
  std::set<std::string> names;
  for (const WriterReport& writer : channel.writers) {
    if (wish.own_sessions.count(writer.session) > 0) continue;
    const ServiceWord* word = word_of(report, wish, writer.session);
    if (word == nullptr) {
      names.insert(kUnknown);
    } else if (!is_own(wish, *word)) {
      names.insert(who(*word));
    }
  }
  return names;
}

// What each of them writes of that.
std::map<std::string, std::string> writers_in_the_way(const Report& report, const RoomWish& wish) {
  std::map<std::string, std::string> channels_by_writer;
  for (const ChannelReport& channel : report.channels) {
    if (!is_its_robot(wish, census::robot_of(channel.channel)) || !shall_write(wish, channel.channel)) continue;
    for (const std::string& writer : other_writers(report, wish, channel)) {
      std::string& names = channels_by_writer[writer];
      names += (names.empty() ? "" : ", ") + channel.channel;
    }
  }
  return channels_by_writer;
}

}  // namespace

bool needs_room(const std::vector<std::string>& services) {
  return std::any_of(services.begin(), services.end(),
                     [](const std::string& service) { return channel_of_its_own(service) != nullptr; });
}

bool somebody_is_unknown(const Report& report, const RoomWish& wish) {
  return writers_in_the_way(report, wish).count(kUnknown) > 0;
}

std::vector<std::string> obstacles(const Report& report, const RoomWish& wish) {
  const auto channels_by_writer = writers_in_the_way(report, wish);
  std::vector<std::string> lines;
  for (const auto& [writer, names] : channels_by_writer) {
    std::string line = writer;
    line.append(" writes ").append(names);
    lines.push_back(reflection::printable(line));
  }
  for (const ServiceReport& service : report.services) {
    const ServiceWord& word = service.newest;
    const bool wished = std::find(wish.services.begin(), wish.services.end(), word.name) != wish.services.end();
    if (!wished || !is_its_robot(wish, word.robot) || is_own(wish, word)) continue;
    const channels::Entry* own_channel = channel_of_its_own(word.name);
    if (own_channel == nullptr || channels_by_writer.count(who(word)) > 0) continue;
    lines.push_back(reflection::printable(who(word) + " runs already: it alone may write " + own_channel->name));
  }
  return lines;
}

}  // namespace markservo::bus_census
