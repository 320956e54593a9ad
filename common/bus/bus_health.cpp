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

std::optional<Health> Bus::network_health() const {
  return network_->health(steady_clock::now());
}

std::optional<Health> Bus::inputs_health() const {
  if (replaying()) return std::nullopt;
  return health_.of_inputs(steady_clock::now());
}

void Bus::set_state(const std::string& state, const std::string& reason) {
  if (health_.set_own({state, reason})) tell(told_health(health_.own(), network_health(), inputs_health()));
}

// Reasons of the bus itself change with every refused message: they are told with the next heartbeat.
void Bus::look_after_health() {
  const auto network = network_health();
  const auto inputs = inputs_health();
  const Health health = told_health(health_.own(), network, inputs);
  if (health.state != health_.told().state || (!network && !inputs)) tell(health);
  const auto now = steady_clock::now();
  health_.log(network, inputs, network_->out().refused_sends(now).total, now);
}

void Bus::tell(const Health& health) {
  if (!health_.set_told(health) || !status_publisher_) return;
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
