// What a Bus does about its network and what it says of its service.

#include <chrono>
#include <markservo/ServiceStatus.hpp>
#include <stdexcept>
#include <utility>

#include "common/bus/bus.hpp"
#include "common/bus/connection.hpp"
#include "common/logging/log.hpp"

namespace markservo::bus {
namespace {

using std::chrono::steady_clock;

// Before the log says what is waited for: whoever starts a stack starts its services one after another.
constexpr std::chrono::seconds kLogAfter{2};

// So many heartbeats were sent, and neither they nor anything else came in: the bus is deaf.
constexpr int kDeafAfter = 3;

double seconds_since(steady_clock::time_point then, steady_clock::time_point now) {
  return std::chrono::duration<double>(now - then).count();
}

}  // namespace

void Bus::open() {
  for (Connection* connection : {in_.get(), out_.get()}) {
    if (connection->lcm() != nullptr || connection->open()) continue;
    // A server's address may be a slip; a route that is missing is not.
    if (!parameters_.waits_for_network || !is_udpm(connection->url())) {
      throw BusUnavailable("bus " + connection->url() + ": cannot be joined: " + connection->trouble());
    }
  }
  look_after_health();
}

void Bus::mend_network() {
  const auto now = steady_clock::now();
  for (Connection* connection : {in_.get(), out_.get()}) {
    if (connection->is_open()) continue;
    if (!parameters_.waits_for_network) {
      throw BusUnavailable("bus " + connection->url() + ": " + connection->trouble());
    }
    if (connection->mend(now)) heartbeats_unheard_ = 0;
  }
  if (echo_ && heartbeats_unheard_ >= kDeafAfter) {
    heartbeats_unheard_ = 0;
    lose_input("hears nothing, not even what it sends itself");
  }
}

void Bus::lose_input(const std::string& why) {
  const bool is_network = is_udpm(in_->url()) || is_tcpq(in_->url());
  if (!is_network || !parameters_.waits_for_network) throw BusUnavailable("bus " + in_->url() + ": " + why);
  in_->lose(why, steady_clock::now());
}

void Bus::note_traffic() {
  heartbeats_unheard_ = 0;
}

void Bus::need(const channels::Entry& channel, double within) {
  const std::string name = full_channel(channel.name);
  for (const auto& subscription : subscriptions_) {
    if (subscription->channel() != name) continue;
    needs_.push_back({subscription.get(), within});
    return;
  }
  throw std::logic_error("need " + name + ": is not subscribed; allowed: channels that are");
}

std::optional<Health> Bus::network_health() const {
  for (const Connection* connection : {in_.get(), out_.get()}) {
    if (!connection->is_open()) return Health{kWaiting, "no network: " + connection->trouble()};
  }
  const RefusedSends refused = out_->refused_sends(steady_clock::now());
  if (refused.lately == 0) return std::nullopt;
  return Health{kWaiting, "the network refuses " + refused.channel + ": " + refused.reason};
}

std::optional<Health> Bus::inputs_health() const {
  if (replaying_) return std::nullopt;
  const auto now = steady_clock::now();
  std::vector<NeededInput> inputs;
  inputs.reserve(needs_.size());
  for (const Need& need : needs_) {
    const Subscription& subscription = *need.subscription;
    NeededInput input;
    input.channel = subscription.channel();
    input.max_age = need.within;
    if (const auto when = subscription.accepted_at()) input.accepted_age = seconds_since(*when, now);
    if (const auto when = subscription.refused_at()) input.refused_age = seconds_since(*when, now);
    input.refusal = subscription.refusal();
    inputs.push_back(std::move(input));
  }
  return health_of(inputs);
}

void Bus::set_state(const std::string& state, const std::string& reason) {
  const Health own{state, reason};
  if (own == own_) return;
  own_ = own;
  tell(told_health(own_, network_health(), inputs_health()));
}

// Reasons of the bus itself change with every refused message: they are told with the next heartbeat.
void Bus::look_after_health() {
  const auto network = network_health();
  const auto inputs = inputs_health();
  const Health health = told_health(own_, network, inputs);
  if (health.state != told_.state || (!network && !inputs && !(health == told_))) tell(health);
  log_trouble(network, inputs);
}

void Bus::tell(const Health& health) {
  if (health == told_) return;
  told_ = health;
  if (!status_publisher_) return;
  try {
    publish_status();
  } catch (const std::exception& error) {
    complain("SERVICE_STATUS", error.what());
  }
}

// While there is no network, nothing can be said of the inputs.
void Bus::log_trouble(const std::optional<Health>& network, const std::optional<Health>& inputs) {
  const auto now = steady_clock::now();
  if (const auto lasted = network_log_.follow(network, std::chrono::seconds(0), now)) {
    logging::info("the network is back after {:.1f} s; it refused {} messages in all", *lasted,
                  out_->refused_sends(now).total);
  }
  if (network) return;
  if (const auto lasted = input_log_.follow(inputs, kLogAfter, now)) {
    logging::info("goes on after {:.1f} s", *lasted);
  }
}

std::optional<double> Bus::TroubleLog::follow(const std::optional<Health>& trouble, std::chrono::seconds patience,
                                              steady_clock::time_point now) {
  if (!trouble) {
    const bool was_told = std::exchange(is_told, false);
    const double lasted = since ? seconds_since(*since, now) : 0.0;
    since.reset();
    return was_told ? std::optional<double>(lasted) : std::nullopt;
  }
  if (!since) since = now;
  if (is_told || now - *since < patience) return std::nullopt;
  // Whoever is started before the others waits for them: that is as it should be.
  if (patience.count() > 0 && trouble->state == kWaiting) {
    logging::info("{}: {}", trouble->state, trouble->reason);
  } else {
    logging::warn("{}: {}", trouble->state, trouble->reason);
  }
  is_told = true;
  return std::nullopt;
}

void Bus::publish_status() {
  ServiceStatus message = status();
  status_publisher_->publish(message);
}

}  // namespace markservo::bus
