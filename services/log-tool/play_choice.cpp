#include "services/log-tool/play_choice.hpp"

#include <markservo/channels.hpp>

#include "common/reflection/message_value.hpp"
#include "common/reflection/value_text.hpp"
#include "services/log-tool/log_format.hpp"

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

const char* why(Fate fate) {
  switch (fate) {
    case Fate::kMoves:
      return "moves a robot; --all plays it";
    case Fate::kLive:
      return "speaks for devices and services that are not there; --all plays it";
    case Fate::kUnlisted:
      return "not in the table of channels; --channel plays it";
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
  if (channel.empty() || channel.size() > kLongestLcmChannel || channel.find('\0') != std::string::npos) {
    return Fate::kNoName;
  }
  if (wishes.channels && !wishes.channels->matches(channel)) return Fate::kNotNamed;
  const channels::Entry* entry = entry_of(channel);
  if (!wishes.all) {
    if (entry == nullptr && !wishes.channels) return Fate::kUnlisted;
    if (entry != nullptr && entry->moves_robot) return Fate::kMoves;
    if (entry != nullptr && entry->live) return Fate::kLive;
  }
  if (wishes.join) {
    if (wishes.written.count(channel) > 0) return Fate::kWritten;
    if (entry != nullptr && entry->feeds_motion) return Fate::kFeedsMotion;
  }
  return Fate::kPlayed;
}

PlayPlan plan_of(const std::vector<Event>& events, const PlayWishes& wishes, const reflection::TypeCatalog& types,
                 const std::function<bool()>& goes_on) {
  const std::set<std::uint64_t> moving = moving_types(types);
  const auto moves = [&](const Event& event) {
    std::uint64_t fingerprint = 0;
    return reflection::read_fingerprint(event.data.data, event.data.size, &fingerprint) &&
           moving.count(fingerprint) > 0;
  };
  PlayPlan plan;
  std::map<std::string, Fate, std::less<>> fates;
  for (const Event& event : events) {
    if (!goes_on()) break;
    auto known = fates.find(event.channel);
    if (known == fates.end()) {
      const std::string name(event.channel);
      known = fates.emplace(name, fate_of(name, wishes)).first;
      if (known->second != Fate::kPlayed) plan.left_out[known->second].push_back(name);
    }
    if (known->second != Fate::kPlayed) continue;
    if (!wishes.all && moves(event)) {
      ++plan.moving_messages[known->first];
      continue;
    }
    plan.events.push_back(event);
    plan.played.insert(known->first);
  }
  return plan;
}

std::vector<std::string> left_out_text(const PlayPlan& plan) {
  std::vector<std::string> lines;
  for (const auto& [fate, channels] : plan.left_out) {
    if (fate != Fate::kNotNamed) lines.push_back("left out: " + names_of(channels) + " (" + why(fate) + ")");
  }
  for (const auto& [channel, count] : plan.moving_messages) {
    lines.push_back("left out: " + std::to_string(count) + " messages on " + reflection::printable(channel) +
                    " of a type that moves a robot (--all plays them)");
  }
  return lines;
}

}  // namespace markservo::log_tool
