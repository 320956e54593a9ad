#include "services/bus-census/bus_census_node.hpp"

#include <algorithm>
#include <markservo/ServiceStatus.hpp>

#include "common/bus/end_signals.hpp"
#include "common/bus/safe_decode.hpp"
#include "common/reflection/message_note.hpp"
#include "common/text/text.hpp"
#include "common/time/clocks.hpp"

namespace markservo::bus_census {
namespace {

constexpr const char* kStatusChannel = "(.*/)?SERVICE_STATUS";
constexpr int kQueue = 1000;  // messages that wait; rates must not suffer from a slow moment

// As it may be shown: scripts print the words of the JSON.
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

Heard heard_of(const bus::HeardBytes& message) {
  const auto note = reflection::note_of(reflection::TypeCatalog::ours(), message.data, message.size);
  Heard heard;
  heard.channel = text::printable(message.channel);
  heard.bytes = static_cast<int64_t>(message.size);
  heard.utime = message.utime;
  heard.hash = static_cast<int64_t>(note.fingerprint.value_or(0));
  heard.type = note.type;
  if (note.session < 1) return heard;
  heard.session = note.session;
  if (note.seq >= 0) heard.seq = note.seq;
  return heard;
}

}  // namespace

BusCensusNode::BusCensusNode(const std::string& url, bool status_only)
    : listener_(url, status_only ? kStatusChannel : ".*", kQueue,
                [this](const bus::HeardBytes& message) { hear(message); }) {}

void BusCensusNode::hear(const bus::HeardBytes& message) {
  const Heard heard = heard_of(message);
  census_->hear(heard);
  if (heard.hash != ServiceStatus::getHash()) return;
  const auto decoded = bus::safe_decode<ServiceStatus>(message.data, message.size);
  if (!decoded.ok || decoded.message.session < 1) return;
  const ServiceWord word = word_of(decoded.message, message.channel);
  census_->hear(word, heard.utime);
  if (on_status) on_status(word);
}

void BusCensusNode::listen(double seconds) {
  census_.emplace(wall_clock_us());
  const int64_t end = steady_clock_us() + static_cast<int64_t>(1e6 * seconds);
  for (int64_t left = end - steady_clock_us(); left > 0 && !bus::told_to_end(); left = end - steady_clock_us()) {
    listener_.poll(std::chrono::milliseconds(std::min<int64_t>(left / 1000 + 1, 100)));
  }
  end_us_ = wall_clock_us();
}

Report BusCensusNode::report() const {
  return census_->report(end_us_);
}

}  // namespace markservo::bus_census
