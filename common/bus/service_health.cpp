#include "common/bus/service_health.hpp"

#include <utility>

#include "common/logging/log.hpp"

namespace markservo::bus {
namespace {

// Before the log says what is waited for: whoever starts a stack starts its services one after another.
constexpr std::chrono::seconds kLogAfter{2};

double seconds_since(Subscription::Time then, Subscription::Time now) {
  return std::chrono::duration<double>(now - then).count();
}

}  // namespace

std::optional<double> TroubleLog::follow(const std::optional<Health>& trouble, std::chrono::seconds patience,
                                         Subscription::Time now) {
  if (!trouble) {
    const bool was_told = std::exchange(is_told_, false);
    const double lasted = since_ ? seconds_since(*since_, now) : 0.0;
    since_.reset();
    return was_told ? std::optional<double>(lasted) : std::nullopt;
  }
  if (!since_) since_ = now;
  if (is_told_ || now - *since_ < patience) return std::nullopt;
  // Whoever is started before the others waits for them: that is as it should be.
  if (patience.count() > 0 && trouble->state == kWaiting) {
    logging::info("{}: {}", trouble->state, trouble->reason);
  } else {
    logging::warn("{}: {}", trouble->state, trouble->reason);
  }
  is_told_ = true;
  return std::nullopt;
}

std::optional<Health> ServiceHealth::of_inputs(Subscription::Time now) const {
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

bool ServiceHealth::set_own(const Health& own) {
  if (own == own_) return false;
  own_ = own;
  return true;
}

bool ServiceHealth::set_told(const Health& told) {
  if (told == told_) return false;
  told_ = told;
  return true;
}

// While there is no network, nothing can be said of the inputs.
void ServiceHealth::log(const std::optional<Health>& network, const std::optional<Health>& inputs, std::int64_t refused,
                        Subscription::Time now) {
  if (const auto lasted = network_log_.follow(network, std::chrono::seconds(0), now)) {
    logging::info("the network is back after {:.1f} s; it refused {} messages in all", *lasted, refused);
  }
  if (network) return;
  if (const auto lasted = input_log_.follow(inputs, kLogAfter, now)) {
    logging::info("goes on after {:.1f} s", *lasted);
  }
}

}  // namespace markservo::bus
