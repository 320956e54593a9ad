// What a Bus says of its service.

#include <chrono>
#include <markservo/ServiceStatus.hpp>
#include <stdexcept>

#include "common/bus/bus.hpp"
#include "common/bus/network.hpp"

namespace markservo::bus {

using std::chrono::steady_clock;

void Bus::need(const channels::Entry& channel, double within) {
  const std::string name = full_channel(channel.name);
  for (const auto& subscription : subscriptions_) {
    if (subscription->channel() != name) continue;
    health_.need(*subscription, within);
    return;
  }
  throw std::logic_error("need " + name + ": is not subscribed; allowed: channels that are");
}

std::optional<Word> Bus::word_of_network() const {
  return network_->word(steady_clock::now());
}

std::optional<Word> Bus::word_of_inputs() const {
  if (replaying()) return std::nullopt;
  return health_.word_of_inputs(steady_clock::now());
}

void Bus::set_state(const std::string& state, const std::string& reason) {
  if (health_.say({state, reason})) tell(told_word(health_.own(), word_of_network(), word_of_inputs()));
}

// Reasons of the bus itself change with every refused message: they are told with the next heartbeat.
void Bus::look_after_health() {
  const auto network = word_of_network();
  const auto inputs = word_of_inputs();
  const Word word = told_word(health_.own(), network, inputs);
  if (word.state != health_.told().state || (!network && !inputs)) tell(word);
  const auto now = steady_clock::now();
  health_.log(network, inputs, network_->out().refused_sends(now).total, now);
}

void Bus::tell(const Word& word) {
  if (!health_.tell(word) || !status_publisher_) return;
  try {
    publish_status();
  } catch (const std::exception& error) {
    complain("SERVICE_STATUS", error.what());
  }
}

void Bus::publish_status() {
  ServiceStatus message = status();
  status_publisher_->publish(message);
}

}  // namespace markservo::bus
