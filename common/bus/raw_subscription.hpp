#pragma once

// One subscribed channel whose messages are passed on as bytes: counted, not decoded. Used by Bus only.

#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "common/bus/subscription.hpp"

namespace markservo::bus {

class RawSubscription final : public Subscription {
 public:
  using Handler = std::function<bool(const void* data, std::size_t size)>;

  RawSubscription(SubscriptionHost* host, std::string channel, Handler handler)
      : Subscription(std::move(channel)), host_(host), handler_(std::move(handler)) {}

  void receive(const void* data, std::size_t size) override {
    try {
      const bool used = handler_(data, size);
      ++counters_.received;
      if (!used) ++counters_.skipped;
    } catch (const std::exception& error) {
      ++counters_.refused;
      host_->complain(channel_, error.what());
    }
  }

  // All is done on arrival.
  void dispatch() override {}

 private:
  SubscriptionHost* host_;
  Handler handler_;
};

}  // namespace markservo::bus
