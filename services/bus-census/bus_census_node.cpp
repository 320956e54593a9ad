#include "services/bus-census/bus_census_node.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <markservo/ServiceStatus.hpp>

#include "common/bus/bus.hpp"
#include "common/bus/network_check.hpp"
#include "common/bus/safe_decode.hpp"
#include "common/reflection/message_note.hpp"
#include "services/bus-census/clock_reader.hpp"

namespace markservo::bus_census {
namespace {

constexpr const char* kStatusChannel = "(.*/)?SERVICE_STATUS";
constexpr int kQueue = 1000;  // messages that wait; rates must not suffer from a slow moment

volatile std::sig_atomic_t told_to_end = 0;

void on_signal(int) {
  told_to_end = 1;
}

ServiceWord word_of(const ServiceStatus& status, const std::string& channel) {
  ServiceWord word;
  word.robot = robot_of(channel);
  word.name = status.name;
  word.host = status.host;
  word.pid = status.pid;
  word.session = status.session;
  word.version = status.version;
  word.config_hash = status.config_hash;
  word.state = status.state;
  word.reason = status.reason;
  word.utime = status.utime;
  for (const ChannelStatus& each : status.channels) {
    word.channels.push_back({each.channel, each.received, each.skipped, each.lost, each.decode_failures, each.refused,
                             each.second_writer != 0, each.age, each.latency_p50, each.latency_p99});
  }
  return word;
}

Heard heard_of(const lcm::ReceiveBuffer& buffer, const std::string& channel) {
  const auto note = reflection::note_of(reflection::TypeCatalog::ours(), buffer.data, buffer.data_size);
  Heard heard;
  heard.channel = channel;
  heard.bytes = buffer.data_size;
  heard.utime = buffer.recv_utime;
  heard.hash = static_cast<int64_t>(note.fingerprint.value_or(0));
  heard.type = note.type;
  if (note.session < 1) return heard;
  heard.session = note.session;
  if (note.seq >= 0) heard.seq = note.seq;
  return heard;
}

}  // namespace

BusCensusNode::BusCensusNode(const std::string& url, bool status_only) : url_(url), lcm_(url) {
  if (!lcm_.good()) throw bus::BusUnavailable("bus " + url + ": cannot be joined; " + bus::multicast_route_advice());
  lcm_.subscribeFunction(status_only ? kStatusChannel : ".*", raw_handler, this)->setQueueCapacity(kQueue);
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

void BusCensusNode::raw_handler(const lcm::ReceiveBuffer* buffer, const std::string& channel, BusCensusNode* node) {
  node->hear(buffer, channel);
}

void BusCensusNode::hear(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
  const Heard heard = heard_of(*buffer, channel);
  census_->hear(heard);
  if (heard.hash != ServiceStatus::getHash()) return;
  const auto decoded = bus::safe_decode<ServiceStatus>(buffer->data, static_cast<std::size_t>(buffer->data_size));
  if (!decoded.ok || decoded.message.session < 1) return;
  const ServiceWord word = word_of(decoded.message, channel);
  census_->hear(word, heard.utime);
  if (on_status) on_status(word);
}

void BusCensusNode::listen(double seconds) {
  census_.emplace(wall_clock_us());
  const int64_t end = steady_clock_us() + static_cast<int64_t>(1e6 * seconds);
  for (int64_t left = end - steady_clock_us(); left > 0 && told_to_end == 0; left = end - steady_clock_us()) {
    errno = 0;
    const auto wait_ms = static_cast<int>(std::min<int64_t>(left / 1000 + 1, 100));
    if (lcm_.handleTimeout(wait_ms) < 0 && errno != EINTR) {
      throw bus::BusUnavailable("bus " + url_ + ": cannot be read any more");
    }
  }
  end_us_ = wall_clock_us();
}

Report BusCensusNode::report() const {
  return census_->report(end_us_);
}

}  // namespace markservo::bus_census
