#include "services/bus-census/bus_census_node.hpp"

#include <algorithm>
#include <cstdint>

#include "common/bus/end_signals.hpp"
#include "common/census/census_messages.hpp"
#include "common/time/clocks.hpp"

namespace markservo::bus_census {
namespace {

constexpr const char* kStatusChannel = "(.*/)?SERVICE_STATUS";
constexpr int kQueue = 1000;  // messages that wait; rates must not suffer from a slow moment

}  // namespace

BusCensusNode::BusCensusNode(const std::string& url, bool status_only)
    : listener_(url, status_only ? kStatusChannel : ".*", kQueue,
                [this](const bus::HeardBytes& message) { on_message(message); }) {}

void BusCensusNode::on_message(const bus::HeardBytes& message) {
  census_->observe(census::heard_of(message.channel, message.data, message.size, message.size, message.utime));
  const auto word = census::word_in(message.channel, message.data, message.size);
  if (!word) return;
  census_->observe(*word, message.utime);
  if (on_status) on_status(*word);
}

void BusCensusNode::listen(double seconds) {
  census_.emplace(wall_clock_us());
  listen_on(seconds);
}

void BusCensusNode::listen_on(double seconds) {
  const std::int64_t end = steady_clock_us() + static_cast<std::int64_t>(1e6 * seconds);
  for (std::int64_t left = end - steady_clock_us(); left > 0 && !bus::told_to_end(); left = end - steady_clock_us()) {
    listener_.poll(std::chrono::milliseconds(std::min<std::int64_t>(left / 1000 + 1, 100)));
  }
  end_us_ = wall_clock_us();
}

census::Report BusCensusNode::report() const {
  return census_->report(end_us_);
}

}  // namespace markservo::bus_census
