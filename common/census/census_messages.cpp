#include "common/census/census_messages.hpp"

#include <lcm/lcm_coretypes.h>

#include <markservo/channels.hpp>

#include "common/bus/safe_decode.hpp"
#include "common/messages/message_rules.hpp"
#include "common/reflection/message_value.hpp"
#include "common/text/text.hpp"

namespace markservo::census {
namespace {

constexpr std::size_t kNumber = 8;  // bytes of a fingerprint and of an int64

// The int64 fields that a message begins with: utime, session, seq in every stream.
void read_writer(const reflection::MessageType& type, const void* data, std::size_t size, Heard* heard) {
  std::size_t at = kNumber;
  for (const reflection::Field& field : type.fields) {
    if (field.kind != reflection::Kind::kInt64 || !field.dimensions.empty() || at + kNumber > size) return;
    int64_t value = 0;
    __int64_t_decode_array(data, static_cast<int>(at), static_cast<int>(size - at), &value, 1);
    if (field.name == "session" && value >= 1) heard->session = value;
    if (field.name == "seq" && value >= 0 && heard->session) heard->seq = value;
    at += kNumber;
  }
}

}  // namespace

Heard heard_of(const std::string& channel, const void* data, std::size_t size, std::size_t whole_size, int64_t utime) {
  Heard heard;
  heard.channel = text::printable(channel);
  heard.bytes = static_cast<int64_t>(whole_size);
  heard.utime = utime;
  std::uint64_t fingerprint = 0;
  if (!reflection::read_fingerprint(data, size, &fingerprint)) return heard;
  heard.hash = static_cast<int64_t>(fingerprint);
  const reflection::MessageType* type = reflection::TypeCatalog::ours().find(fingerprint);
  if (type == nullptr) return heard;
  heard.type = type->name;
  read_writer(*type, data, size, &heard);
  return heard;
}

std::optional<ServiceWord> word_in(const std::string& channel, const void* data, std::size_t size) {
  if (channel.substr(channel.rfind('/') + 1) != channels::kServiceStatus.name) return std::nullopt;
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
