#include "services/log-tool/play_choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <markservo/channels.hpp>

#include "common/logs/bus_limits.hpp"
#include "common/reflection/message_value.hpp"
#include "common/reflection/value_text.hpp"

namespace markservo::log_tool {
namespace {

// Where a log has thousands, the first will do.
constexpr std::size_t kNamesTold = 20;

const channels::Entry* entry_of(const std::string& channel) {
  return channels::find(channel.substr(channel.rfind('/') + 1));
}

std::set<std::uint64_t> moving_types(const reflection::TypeCatalog& types) {
  std::set<std::uint64_t> fingerprints;
  for (const channels::Entry& entry : channels::kAll) {
    const reflection::MessageType* type = entry.moves_robot ? types.find(entry.type) : nullptr;
    if (type != nullptr) fingerprints.insert(type->fingerprint);
  }
  return fingerprints;
}

// Of single messages on channels that may be played.
class MessageJudge {
 public:
  MessageJudge(const PlayWishes& wishes, const reflection::TypeCatalog& types)
      : wishes_(wishes), types_(types), moving_(moving_types(types)), names_others_(wishes.names_others()) {}

  // False notes in the plan why not.
  bool lets_through(const std::string& channel, const logs::LogEvent& event, PlayPlan& plan) const {
    std::uint64_t fingerprint = 0;
    const bool has_type = reflection::read_fingerprint(event.data.data, event.data.size, &fingerprint);
    if (!wishes_.all && has_type && moving_.count(fingerprint) > 0) {
      ++plan.moving_messages[channel];
    } else if (!names_others_ && (!has_type || types_.find(fingerprint) == nullptr)) {
      ++plan.others_messages[channel];
    } else if (wishes_.by_udp && event.data.size > logs::kLargestByUdp) {
      TooLarge& too_large = plan.too_large[channel];
      ++too_large.messages;
      too_large.largest = std::max(too_large.largest, event.data.size);
    } else {
      return true;
    }
    return false;
  }

 private:
  const PlayWishes& wishes_;
  const reflection::TypeCatalog& types_;
  std::set<std::uint64_t> moving_;
  bool names_others_;
};

const char* why(Fate fate) {
  switch (fate) {
    case Fate::kMoves:
      return "moves a robot; --all plays it";
    case Fate::kLive:
      return "speaks for devices and services that are not there; --all plays it";
    case Fate::kUnlisted:
      return "not in the table of channels: another system's, which may move a robot; --channel NAME plays it";
    case Fate::kWritten:
      return "somebody writes it";
    case Fate::kFeedsMotion:
      return "what moves on the bus would decide by it";
    case Fate::kNoName:
      return "no channel's name";
    case Fate::kPlayed:
    case Fate::kNotNamed:
      break;
  }
  return "";
}

std::string names_of(const std::vector<std::string>& channels) {
  std::string names;
  for (std::size_t i = 0; i < channels.size() && i < kNamesTold; ++i) {
    names += (i == 0 ? "" : ", ") + reflection::printable(channels[i]);
  }
  if (channels.size() > kNamesTold) names += " and " + std::to_string(channels.size() - kNamesTold) + " more";
  return names;
}

}  // namespace

Fate fate_of(const std::string& channel, const PlayWishes& wishes) {
  if (channel.empty() || channel.size() > logs::kLongestLcmChannel || channel.find('\0') != std::string::npos) {
    return Fate::kNoName;
  }
  if (wishes.channels && !wishes.channels->matches(channel)) return Fate::kNotNamed;
  const channels::Entry* entry = entry_of(channel);
  if (entry == nullptr && !wishes.names_others()) return channel == kLcmSelfTest ? Fate::kNotNamed : Fate::kUnlisted;
  if (!wishes.all) {
    if (entry != nullptr && entry->moves_robot) return Fate::kMoves;
    if (entry != nullptr && entry->live) return Fate::kLive;
  }
  if (wishes.join) {
    if (wishes.written.count(channel) > 0) return Fate::kWritten;
    if (entry != nullptr && entry->feeds_motion) return Fate::kFeedsMotion;
  }
  return Fate::kPlayed;
}

PlayPlan plan_of(const std::vector<logs::LogEvent>& events, const PlayWishes& wishes,
                 const reflection::TypeCatalog& types, const std::function<bool()>& goes_on) {
  const MessageJudge judge(wishes, types);
  PlayPlan plan;
  std::map<std::string, Fate, std::less<>> fates;
  for (const logs::LogEvent& event : events) {
    if (!goes_on()) break;
    auto known = fates.find(event.channel);
    if (known == fates.end()) {
      const std::string name(event.channel);
      known = fates.emplace(name, fate_of(name, wishes)).first;
      if (known->second != Fate::kPlayed) plan.left_out[known->second].push_back(name);
    }
    if (known->second == Fate::kPlayed && judge.lets_through(known->first, event, plan)) {
      plan.events.push_back(event);
      plan.played.insert(known->first);
    }
  }
  return plan;
}

std::string others_played_text(const PlayPlan& plan) {
  std::vector<std::string> others;
  std::copy_if(plan.played.begin(), plan.played.end(), std::back_inserter(others),
               [](const std::string& channel) { return entry_of(channel) == nullptr; });
  if (others.empty()) return {};
  return "also plays " + names_of(others) + " (not in the table of channels: another system's, which may move a robot)";
}

std::vector<std::string> left_out_text(const PlayPlan& plan) {
  std::vector<std::string> lines;
  for (const auto& [fate, channels] : plan.left_out) {
    if (fate != Fate::kNotNamed) lines.push_back("left out: " + names_of(channels) + " (" + why(fate) + ")");
  }
  const auto messages = [](std::int64_t count, const std::string& channel) {
    return fmt::format("left out: {} message{} on {}", count, count == 1 ? "" : "s", reflection::printable(channel));
  };
  for (const auto& [channel, count] : plan.moving_messages) {
    lines.push_back(messages(count, channel) + " of a type that moves a robot (--all plays them)");
  }
  for (const auto& [channel, count] : plan.others_messages) {
    lines.push_back(messages(count, channel) + " of a type that is not ours (--channel NAME plays them)");
  }
  for (const auto& [channel, too_large] : plan.too_large) {
    lines.push_back(messages(too_large.messages, channel) +
                    fmt::format(" of up to {:.1f} MB: above {:.0f} MB a bus by UDP loses them",
                                1e-6 * static_cast<double>(too_large.largest), 1e-6 * logs::kLargestByUdp));
  }
  return lines;
}

}  // namespace markservo::log_tool
