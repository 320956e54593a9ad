#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/health.hpp"
#include "common/bus/subscription.hpp"

namespace markservo::bus {

// Logs a trouble once when it begins, and gives how long it lasted when it is over.
class TroubleLog {
 public:
  // Nothing is told before it has lasted for `patience`. The duration, s, of one that was told and is over.
  std::optional<double> follow(const std::optional<Health>& trouble, std::chrono::seconds patience,
                               Subscription::Time now);

 private:
  std::optional<Subscription::Time> since_;
  bool is_told_ = false;
};

// What a service says of itself, what it needs, and what was last told of it.
class ServiceHealth {
 public:
  // `subscription` outlives this; `within` as Bus::need().
  void need(const Subscription& subscription, double within) { needs_.push_back({&subscription, within}); }
  // The first need that is not met.
  std::optional<Health> of_inputs(Subscription::Time now) const;

  // How the service says it is. False if it said that already.
  bool set_own(const Health& own);
  const Health& own() const { return own_; }

  // False if it was told already.
  bool set_told(const Health& told);
  const Health& told() const { return told_; }

  // Logs what keeps the service from its work, and its end. `refused`: messages that the network refused, in all.
  void log(const std::optional<Health>& network, const std::optional<Health>& inputs, std::int64_t refused,
           Subscription::Time now);

 private:
  struct Need {
    const Subscription* subscription;
    double within;  // s
  };

  std::vector<Need> needs_;
  Health own_{kStarting, {}};
  Health told_{kStarting, {}};
  TroubleLog network_log_;
  TroubleLog input_log_;
};

}  // namespace markservo::bus
