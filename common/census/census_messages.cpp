#include "common/census/census_messages.hpp"

#include <lcm/lcm_coretypes.h>

#include <cstdint>
#include <limits>
#include <markservo/channels.hpp>

#include "common/bus/health.hpp"
#include "common/bus/safe_decode.hpp"
#include "common/messages/message_rules.hpp"
#include "common/reflection/message_value.hpp"
#include "common/text/text.hpp"

namespace markservo::census {
namespace {

constexpr std::size_t kNumber = 8;  // bytes of a fingerprint and of an int64

// The part of a channel's name after any prefix.
std::string own_name(const std::string& channel) {
  return channel.substr(channel.rfind('/') + 1);
}

// The type that the channel carries by our table; null: it is none of ours.
const reflection::MessageType* type_of_channel(const std::string& channel) {
  const channels::Entry* entry = channels::find(own_name(channel));
  return entry == nullptr ? nullptr : reflection::TypeCatalog::ours().find(std::string(entry->type));
}

// The int64 fields that a message begins with: utime, session, seq in every stream.
void read_writer(const reflection::MessageType& type, const void* data, std::size_t size, Heard* heard) {
  std::size_t at = kNumber;
  for (const reflection::Field& field : type.fields) {
    if (field.kind != reflection::Kind::kInt64 || !field.dimensions.empty() || at + kNumber > size) return;
    std::int64_t value = 0;
    __int64_t_decode_array(data, static_cast<int>(at), static_cast<int>(size - at), &value, 1);
    if (field.name == "session" && value >= 1) heard->session = value;
    if (field.name == "seq" && value >= 0 && heard->session) heard->seq = value;
    at += kNumber;
  }
}

bool is_of_unknown_type(const void* data, std::size_t size) {
  std::uint64_t fingerprint = 0;
  return reflection::read_fingerprint(data, size, &fingerprint) &&
         reflection::TypeCatalog::ours().find(fingerprint) == nullptr;
}

// A string as LCM writes it at `*at`, which moves on: its length with the zero that ends it, then the bytes. False
// where there is none.
bool read_text(const char* data, std::size_t size, std::size_t* at, std::string* text) {
  constexpr std::size_t kLength = 4;  // bytes
  std::int32_t length = 0;
  if (*at + kLength > size) return false;
  __int32_t_decode_array(data, static_cast<int>(*at), static_cast<int>(size - *at), &length, 1);
  *at += kLength;
  if (length < 1 || static_cast<std::size_t>(length) > size - *at) return false;
  text->assign(data + *at, static_cast<std::size_t>(length) - 1);
  *at += static_cast<std::size_t>(length);
  return true;
}

// Who speaks in a SERVICE_STATUS of another version: its fields up to `version` stand first in every one
// (lcmtypes/README.md). Nothing where they make no sense.
std::optional<ServiceWord> head_in(const std::string& channel, const void* bytes, std::size_t size) {
  const char* data = static_cast<const char*>(bytes);
  constexpr std::size_t kNumbers = 4;
  std::int64_t numbers[kNumbers] = {};  // fingerprint, utime, session, seq
  if (size < sizeof numbers || size > static_cast<std::size_t>(std::numeric_limits<int>::max())) return std::nullopt;
  __int64_t_decode_array(data, 0, static_cast<int>(size), numbers, kNumbers);
  std::size_t at = sizeof numbers;
  ServiceStatus head{};
  if (!read_text(data, size, &at, &head.name) || !read_text(data, size, &at, &head.host)) return std::nullopt;
  if (at + sizeof head.pid > size) return std::nullopt;
  __int32_t_decode_array(data, static_cast<int>(at), static_cast<int>(size - at), &head.pid, 1);
  at += sizeof head.pid;
  if (!read_text(data, size, &at, &head.version)) return std::nullopt;
  head.utime = numbers[1];
  head.session = numbers[2];
  head.seq = numbers[3];
  head.state = bus::kWaiting;
  head.reason = bus::other_version_text(ServiceStatus::getTypeName(), numbers[0], ServiceStatus::getHash());
  if (!messages::broken_rule(head).empty()) return std::nullopt;
  return word_of(head, channel);
}

}  // namespace

Heard heard_of(const std::string& channel, const void* data, std::size_t size, std::size_t whole_size,
               std::int64_t utime) {
  Heard heard;
  heard.channel = text::printable(channel);
  heard.bytes = static_cast<std::int64_t>(whole_size);
  heard.utime = utime;
  std::uint64_t fingerprint = 0;
  if (!reflection::read_fingerprint(data, size, &fingerprint)) return heard;
  heard.hash = static_cast<std::int64_t>(fingerprint);
  const reflection::MessageType* type = reflection::TypeCatalog::ours().find(fingerprint);
  if (type != nullptr) {
    heard.type = type->name;
    read_writer(*type, data, size, &heard);
  } else if (const reflection::MessageType* ours = type_of_channel(channel)) {
    Heard head;
    read_writer(*ours, data, size, &head);
    heard.other_version =
        OtherVersion{ours->name, static_cast<std::int64_t>(ours->fingerprint), head.session.value_or(0)};
  }
  return heard;
}

std::optional<ServiceWord> word_in(const std::string& channel, const void* data, std::size_t size) {
  if (own_name(channel) != channels::kServiceStatus.name) return std::nullopt;
  if (is_of_unknown_type(data, size)) return head_in(channel, data, size);
  const auto decoded = bus::safe_decode<ServiceStatus>(data, size);
  if (!decoded.ok || !messages::broken_rule(decoded.message).empty()) return std::nullopt;
  return word_of(decoded.message, channel);
}

// As it may be shown: scripts and people read it.
ServiceWord word_of(const ServiceStatus& status, const std::string& channel) {
  ServiceWord word;
  word.robot = robot_of(text::printable(channel));
  word.name = text::printable(status.name);
  word.host = text::printable(status.host);
  word.pid = status.pid;
  word.session = status.session;
  word.version = text::printable(status.version);
  word.config_hash = status.config_hash;
  word.state = text::printable(status.state);
  word.reason = text::printable(status.reason);
  word.utime = status.utime;
  for (const ChannelStatus& each : status.channels) {
    word.channels.push_back({text::printable(each.channel), each.received, each.skipped, each.lost,
                             each.decode_failures, each.refused, each.second_writer != 0, each.age, each.latency_p50,
                             each.latency_p99});
  }
  return word;
}

}  // namespace markservo::census
