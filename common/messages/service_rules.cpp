// The rules of what services, the stack that runs them and the recorder say of themselves.

#include <cstdint>
#include <markservo/ProcessStatus.hpp>
#include <markservo/RecorderStatus.hpp>
#include <markservo/ServiceStatus.hpp>

#include "common/messages/rule_words.hpp"

namespace markservo::messages {
namespace {

template <class Status, class Visit>
void each_text_of_process(Status& status, Visit& visit) {
  visit("name", status.name);
  visit("host", status.host);
  visit("why", status.why);
}

template <class Status, class Visit>
void each_text_of_recorder(Status& status, Visit& visit) {
  visit("folder", status.folder);
  visit("host", status.host);
  visit("why", status.why);
}

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

std::string MessageRules<ProcessStatus>::violation(const ProcessStatus& status) {
  TextCheck texts;
  each_text_of_process(status, texts);
  if (!texts.why().empty()) return texts.why();
  if (auto why = enum_violation("state", status.state, ProcessStatus::FAILED); !why.empty()) return why;
  if (auto why = count_violation("pid", status.pid); !why.empty()) return why;
  if (auto why = count_violation("start_utime", status.start_utime); !why.empty()) return why;
  return count_violation("restarts", status.restarts);
}

void MessageRules<ProcessStatus>::clean_texts(ProcessStatus& status) {
  TextCleaner cleaner;
  each_text_of_process(status, cleaner);
}

std::string MessageRules<RecorderStatus>::violation(const RecorderStatus& status) {
  TextCheck texts;
  each_text_of_recorder(status, texts);
  if (!texts.why().empty()) return texts.why();
  if (auto why = count_violation("bytes", status.bytes); !why.empty()) return why;
  if (auto why = count_violation("free_bytes", status.free_bytes); !why.empty()) return why;
  return count_violation("parts", status.parts);
}

void MessageRules<RecorderStatus>::clean_texts(RecorderStatus& status) {
  TextCleaner cleaner;
  each_text_of_recorder(status, cleaner);
}

}  // namespace markservo::messages
