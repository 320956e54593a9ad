// The rules of what every service says of itself.

#include <cstdint>
#include <markservo/ServiceStatus.hpp>

#include "common/messages/rule_words.hpp"

namespace markservo::messages {
namespace {

template <class Status, class Visit>
void each_text(Status& status, Visit& visit) {
  visit("name", status.name);
  visit("host", status.host);
  visit("version", status.version);
  visit("state", status.state);
  visit("reason", status.reason);
  for (auto& channel : status.channels) visit("a channel's name", channel.channel);
}

}  // namespace

std::string MessageRules<ServiceStatus>::violation(const ServiceStatus& status) {
  TextCheck texts;
  each_text(status, texts);
  if (!texts.why().empty()) return texts.why();
  for (const auto& channel : status.channels) {
    for (const std::int64_t count :
         {channel.received, channel.skipped, channel.lost, channel.decode_failures, channel.refused}) {
      if (auto why = count_violation("a count of " + channel.channel, count); !why.empty()) return why;
    }
    if (!all_finite({channel.age, channel.latency_p50, channel.latency_p99})) {
      return not_finite("an age or latency of " + channel.channel);
    }
  }
  return {};
}

void MessageRules<ServiceStatus>::clean_texts(ServiceStatus& status) {
  TextCleaner cleaner;
  each_text(status, cleaner);
}

}  // namespace markservo::messages
